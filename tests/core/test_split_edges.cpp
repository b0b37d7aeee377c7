#include "core/mesh_topology.hpp"
#include "core/split_edges.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// Two triangles on one side of an edge from 0 to 1, three on the other.
TriangleMesh with_two_corners_on_an_edge()
{
    TriangleMesh mesh;
    mesh.points = {Vec3(0, 0, 0),   Vec3(0, 1, 0),   Vec3(-1, 0.5, 0),
                   Vec3(1, 0.5, 0), Vec3(0, 0.3, 0), Vec3(0, 0.6, 0)};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}, {4, 3, 5}, {5, 3, 1}};
    return mesh;
}

TEST(WithSplitEdges, MakesAFanOfTheCoarserTriangle)
{
    const SplitEdges split = with_split_edges(with_two_corners_on_an_edge());
    EXPECT_EQ(split.num_corners, 2);
    EXPECT_EQ(split.from, (std::vector<int>{0, 0, 0, 1, 2, 3}));
    const std::vector<std::vector<int>> loops = border_loops(split.mesh);
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_EQ(loops[0].size(), 4U);  // 0, 3, 1, 2
    double area = 0.0;
    for (int triangle = 0; triangle < 6; ++triangle) {
        EXPECT_GT(area_vector(split.mesh, triangle).z(), 0.0);
        area += area_vector(split.mesh, triangle).norm();
    }
    EXPECT_NEAR(area, 1.0, 1e-12);
}

TEST(WithSplitEdges, LeavesOtherSurfacesAsTheyAre)
{
    const TriangleMesh tube = test::tube(2e-3, 20e-3, 24, 20);
    EXPECT_EQ(with_split_edges(tube).num_corners, 0);
    EXPECT_EQ(with_split_edges(tube).mesh.triangles, tube.triangles);
    // A corner a thousandth of the edge off it is no corner on it.
    TriangleMesh apart = with_two_corners_on_an_edge();
    apart.points[4].x() = apart.points[5].x() = 1e-3;
    EXPECT_EQ(with_split_edges(apart).num_corners, 0);
}

// One triangle of a tube is split on its own, in the middle of the side that it shares.
TEST(MakeVessel, ClosesASlitWithoutWidthAndSaysSo)
{
    TriangleMesh mesh = test::tube(2e-3, 20e-3, 24, 20);
    const auto [a, b, c] = mesh.triangles[481];
    const int middle = static_cast<int>(mesh.points.size());
    mesh.points.push_back(0.5 * (mesh.points[static_cast<std::size_t>(a)] +
                                 mesh.points[static_cast<std::size_t>(b)]));
    mesh.triangles[481] = {a, middle, c};
    mesh.triangles.push_back({middle, b, c});
    const Vessel vessel = make_vessel(mesh, LengthUnit{"mm", 1e-3});
    EXPECT_EQ(vessel.openings.size(), 2U);
    EXPECT_THAT(vessel.notes, testing::ElementsAre(testing::HasSubstr("split edges at 1 corners")));
}

}  // namespace
}  // namespace braidzone
