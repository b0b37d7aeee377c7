#include "core/lumen_behind.hpp"
#include "core/mesh_topology.hpp"
#include "core/phantom.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace braidzone {
namespace {

/// The mesh without the triangles about a point, one ring or more.
TriangleMesh with_hole(const TriangleMesh& mesh, const Vec3& middle, double radius)
{
    std::vector<int> kept;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        Vec3 centre = Vec3::Zero();
        for (const int point : mesh.triangles[k])
            centre += mesh.points[static_cast<std::size_t>(point)] / 3.0;
        if ((centre - middle).norm() > radius) kept.push_back(static_cast<int>(k));
    }
    return submesh(mesh, kept);
}

std::vector<LumenBehind> judged(const TriangleMesh& mesh)
{
    Vessel vessel;
    vessel.wall = mesh;
    const WallTree wall(vessel);
    std::vector<LumenBehind> found;
    for (const Opening& opening : measured_openings(mesh))
        found.push_back(lumen_behind(opening, mesh, wall));
    return found;
}

TEST(LumenBehind, OfATubesRimsIsTheTube)
{
    for (const LumenBehind& behind : judged(test::tube(2e-3, 10e-3, 48, 40))) {
        EXPECT_TRUE(behind.is_tube);
        EXPECT_NEAR(behind.radius, 2e-3, 0.01e-3);
    }
}

// Holes from single triangles to 0.45 of the radius.
TEST(LumenBehind, OfAHoleInTheSideIsTheLumen)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 96, 80);
    for (const double radius : {0.1e-3, 0.3e-3, 0.6e-3, 0.9e-3}) {
        const std::vector<LumenBehind> found =
            judged(with_hole(tube, Vec3(2e-3, 0, 5.03e-3), radius));
        ASSERT_EQ(found.size(), 3u) << radius;
        EXPECT_TRUE(found[0].is_tube && found[1].is_tube);
        EXPECT_FALSE(found[2].is_tube) << radius;
        EXPECT_NEAR(found[2].radius, 2e-3, 0.5 * radius + 0.05e-3) << radius;  // steps of 0.5 r
    }
}

// Cut by a plane at 45 degrees the tube's end is a tube still.
TEST(LumenBehind, OfAnObliqueCutIsATube)
{
    TriangleMesh tube = test::tube(2e-3, 10e-3, 48, 40);
    for (Vec3& point : tube.points)
        point.z() += (point.z() / 10e-3) * point.x();
    for (const LumenBehind& behind : judged(tube))
        EXPECT_TRUE(behind.is_tube);
}

// 30 phantoms with a branch of 0.2 to 0.8 of the artery, cut 0.3 of its diameter or more beyond the
// wall, and a hole of one triangle or some ten on the other side.
TEST(LumenBehind, TellsBranchesFromHolesInRandomPhantoms)
{
    std::mt19937 random(5);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int wrong = 0;
    for (int trial = 0; trial < 30; ++trial) {
        Phantom phantom;
        phantom.segments = {{.length = 12e-3, .angle = uniform(0.0, 1.0)}};
        const double radius = uniform(0.2, 0.8) * 2e-3;
        phantom.branches = {{.position = 6e-3,
                             .direction = uniform(0.0, 6.28),
                             .tilt = uniform(1.0, 1.5),
                             .radius = radius,
                             .length = 2.4e-3 + radius + uniform(0.6, 4.0) * radius}};
        const TriangleMesh wall = make_phantom(phantom).wall;
        for (const LumenBehind& behind : judged(wall))
            wrong += behind.is_tube ? 0 : 1;
        const Vec3 place = wall.points[static_cast<std::size_t>(uniform(0.0, 1.0) *
                                                                double(wall.points.size() - 1))];
        const std::vector<LumenBehind> holed =
            judged(with_hole(wall, place, uniform(0.2, 0.5) * 1e-3));
        if (holed.size() == 4) wrong += holed[3].is_tube ? 1 : 0;
    }
    // Holes in the branch itself may be as wide as it, which is no hole by the rule.
    EXPECT_LE(wrong, 2);
}

}  // namespace
}  // namespace braidzone
