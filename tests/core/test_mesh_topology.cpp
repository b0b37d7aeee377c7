#include "core/mesh_topology.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace braidzone {
namespace {

TEST(SortedSides, ListTheTrianglesOfEachEdgeTogether)
{
    // Two triangles that share the edge 1-2.
    const TriangleMesh mesh{std::vector<Vec3>(4, Vec3::Zero()), {{0, 1, 2}, {2, 1, 3}}};
    const std::vector<TriangleSide> sides = sorted_sides(mesh);
    ASSERT_EQ(sides.size(), 6u);
    std::vector<std::array<int, 3>> edges;  // low, high, number of triangles
    for_each_edge(sides, [&](auto first, auto last) {
        edges.push_back({first->low, first->high, static_cast<int>(last - first)});
        if (last - first == 2) {
            EXPECT_EQ(first->triangle, 0);
            EXPECT_TRUE(first->forward);
            EXPECT_EQ((first + 1)->triangle, 1);
            EXPECT_FALSE((first + 1)->forward);
        }
    });
    const std::vector<std::array<int, 3>> expected{
        {0, 1, 1}, {0, 2, 1}, {1, 2, 2}, {1, 3, 1}, {2, 3, 1}};
    EXPECT_EQ(edges, expected);
}

// Seen from outside (from below at z = 0, from above at z = 1) a cap runs anticlockwise: against
// the angle at the lower end, with it at the upper end.
TEST(BorderLoops, OfATubeAreItsTwoRims)
{
    const std::vector<std::vector<int>> loops = border_loops(test::tube(1.0, 1.0, 5, 2));
    const std::vector<std::vector<int>> expected{{0, 4, 3, 2, 1}, {10, 11, 12, 13, 14}};
    EXPECT_EQ(loops, expected);
}

TEST(BorderLoops, OfAClosedSurfaceAreNone)
{
    EXPECT_TRUE(border_loops(test::box(Vec3::Zero(), Vec3::Ones())).empty());
}

// A prism over a regular hexagon of radius 1: area 3 sqrt(3) / 2, height 2.
TEST(AppendFan, ClosesATubeIntoAPrism)
{
    TriangleMesh mesh = test::tube(1.0, 2.0, 6, 1);
    const std::vector<std::vector<int>> loops = border_loops(mesh);
    append_fan(mesh, loops[0], Vec3(0, 0, 0));
    append_fan(mesh, loops[1], Vec3(0, 0, 2));
    EXPECT_TRUE(border_loops(mesh).empty());
    EXPECT_NEAR(enclosed_volume(mesh), 3.0 * std::sqrt(3.0), 1e-14);
}

TEST(Submesh, KeepsTheTrianglesAndOnlyTheirPoints)
{
    const TriangleMesh box = test::box(Vec3::Zero(), Vec3::Ones());
    const TriangleMesh upper_face = submesh(box, {2, 3});
    ASSERT_EQ(upper_face.points.size(), 4u);
    EXPECT_EQ(area_vector(upper_face, 0) + area_vector(upper_face, 1), Vec3(0, 0, 1));
    for (const Vec3& point : upper_face.points)
        EXPECT_EQ(point.z(), 1.0);
}

}  // namespace
}  // namespace braidzone
