#include "core/mesh_topology.hpp"
#include "core/surface_caps.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

TriangleMesh closed_tube(int around, int along)
{
    TriangleMesh mesh = test::tube(2e-3, 10e-3, around, along);
    for (const std::vector<int>& loop : border_loops(mesh)) {
        append_fan(mesh, loop, Vec3(0, 0, mesh.points[static_cast<std::size_t>(loop[0])].z()));
    }
    return mesh;
}

TEST(FlatCaps, OfAClosedTubeAreItsTwoFans)
{
    // 12 x 5 x 2 triangles of the wall, then two fans of 12.
    std::vector<int> lower(12), upper(12);
    for (int k = 0; k < 12; ++k) {
        lower[static_cast<std::size_t>(k)] = 120 + k;
        upper[static_cast<std::size_t>(k)] = 132 + k;
    }
    EXPECT_EQ(flat_caps(closed_tube(12, 5), 5.0), (std::vector<std::vector<int>>{lower, upper}));
}

// A channel of 1 x 1 x 10 has sides of quotient 4 pi 10 / 22^2 = 0.26; its ends are squares.
TEST(FlatCaps, AreNotTheLongSidesOfAPrism)
{
    const TriangleMesh channel = test::box(Vec3::Zero(), Vec3(1, 1, 10));
    EXPECT_EQ(flat_caps(channel, 5.0), (std::vector<std::vector<int>>{{0, 1}, {2, 3}}));
}

// The fan's middle lifted by 0.5 mm over a radius of 2 mm: normals 14 degrees off the axis.
TEST(FlatCaps, AreFlatWithinTheAngle)
{
    TriangleMesh mesh = closed_tube(24, 10);
    mesh.points.back().z() += 0.5e-3;
    EXPECT_EQ(flat_caps(mesh, 5.0).size(), 1u);
    EXPECT_EQ(flat_caps(mesh, 20.0).size(), 2u);
}

// A segmented wall is rough: a wart stands for it, 0.5 mm high, with a flat top of 0.5 x 0.5 mm
// and steep sides. The lumen behind it is 4 mm wide.
TEST(FlatCaps, AreNotTheFacetsOfARoughWall)
{
    constexpr int around = 48;
    TriangleMesh mesh = test::capsule(2e-3, 10e-3, around, 40);
    for (int ring = 30; ring < 33; ++ring) {
        for (int side = 11; side < 14; ++side)  // the point 12 is at y = 2 mm
            mesh.points[static_cast<std::size_t>(1 + ring * around + side)].y() = 2.5e-3;
    }
    EXPECT_TRUE(flat_caps(mesh, 5.0).empty());
}

TEST(FlatCaps, OfAnOpenTubeAreNone)
{
    EXPECT_TRUE(flat_caps(test::tube(2e-3, 10e-3, 24, 10), 5.0).empty());
}

}  // namespace
}  // namespace braidzone
