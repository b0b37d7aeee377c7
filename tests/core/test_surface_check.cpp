#include "core/surface_check.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

using test::joined;
using test::unit_box;

TEST(FindDefects, FindsNoneInSoundSurfaces)
{
    for (const TriangleMesh& mesh : {unit_box(), test::tube(2e-3, 10e-3, 24, 10)}) {
        const SurfaceDefects defects = find_defects(mesh);
        EXPECT_TRUE(is_sound(defects));
        EXPECT_EQ(defects.num_components, 1);
        EXPECT_EQ(describe(defects), "");
    }
}

TEST(FindDefects, NamesTrianglesWithEqualCorners)
{
    TriangleMesh mesh = unit_box();
    mesh.triangles.push_back({2, 2, 5});
    const SurfaceDefects defects = find_defects(mesh);
    EXPECT_EQ(defects.degenerate_triangles, std::vector<int>{12});
    EXPECT_TRUE(defects.non_manifold_edges.empty());  // it joins nothing
    EXPECT_FALSE(is_sound(defects));
    EXPECT_EQ(describe(defects), "1 degenerate triangles: 12\n");
}

// The edge 0-1 gets a point in its middle on one side; a flat triangle closes the gap.
TEST(FindDefects, NamesTrianglesWithoutArea)
{
    TriangleMesh mesh = unit_box();
    mesh.points.emplace_back(0.5, 0, 0);
    mesh.triangles[1] = {0, 3, 8};
    mesh.triangles.push_back({8, 3, 1});
    mesh.triangles.push_back({0, 8, 1});
    const SurfaceDefects defects = find_defects(mesh);
    EXPECT_EQ(defects.degenerate_triangles, std::vector<int>{13});
    EXPECT_TRUE(defects.inconsistent_edges.empty());
    EXPECT_TRUE(defects.non_manifold_edges.empty());
}

TEST(FindDefects, NamesEdgesOfThreeTriangles)
{
    TriangleMesh mesh = unit_box();
    mesh.points.emplace_back(0.5, -1, -1);
    mesh.triangles.push_back({0, 1, 8});  // a fin on the edge 0-1
    const SurfaceDefects defects = find_defects(mesh);
    EXPECT_EQ(defects.non_manifold_edges, (Pairs{{0, 1}}));
    EXPECT_TRUE(defects.non_manifold_points.empty());
    EXPECT_FALSE(is_sound(defects));
    EXPECT_EQ(describe(defects), "1 non-manifold edges, by their points: 0-1\n");
}

TEST(FindDefects, NamesPointsWhereTheSurfacePinches)
{
    // Two boxes that share the corner (1, 1, 1): point 7 of the one, point 0 of the other.
    TriangleMesh mesh = joined(unit_box(), test::box(Vec3::Ones(), 2 * Vec3::Ones()));
    for (auto& corners : mesh.triangles) {
        for (int& point : corners)
            point = point == 8 ? 7 : point;
    }
    const SurfaceDefects defects = find_defects(mesh);
    EXPECT_EQ(defects.non_manifold_points, std::vector<int>{7});
    EXPECT_TRUE(defects.non_manifold_edges.empty());
    EXPECT_EQ(defects.num_components, 1);
    EXPECT_FALSE(is_sound(defects));
}

TEST(FindDefects, NamesTheEdgesOfATurnedTriangle)
{
    TriangleMesh mesh = unit_box();
    mesh.triangles[0] = {0, 3, 2};
    const SurfaceDefects defects = find_defects(mesh);
    EXPECT_EQ(defects.inconsistent_edges, (Pairs{{0, 2}, {0, 3}, {2, 3}}));
    EXPECT_FALSE(defects.is_inverted);
    EXPECT_FALSE(is_sound(defects));
}

// A triangle in z = 0 and an upright one that pierces it, far from both borders.
TEST(FindDefects, NamesTrianglesThatCross)
{
    const TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(1, 0.5, -1),
                             Vec3(1, 1.5, -1), Vec3(1, 1, 1)},
                            {{0, 1, 2}, {3, 4, 5}}};
    const SurfaceDefects defects = find_defects(mesh);
    EXPECT_EQ(defects.intersecting_triangles, (Pairs{{0, 1}}));
    EXPECT_EQ(defects.num_components, 2);
    EXPECT_EQ(describe(defects),
              "1 pairs of intersecting triangles: 0-1\n2 separate parts instead of 1\n");
}

TEST(FindDefects, CountsSeparateParts)
{
    const TriangleMesh mesh =
        joined(unit_box(), test::box(Vec3::Constant(3.0), Vec3::Constant(4.0)));
    const SurfaceDefects defects = find_defects(mesh);
    EXPECT_EQ(defects.num_components, 2);
    EXPECT_TRUE(defects.intersecting_triangles.empty());
    EXPECT_FALSE(is_sound(defects));
}

TEST(FindDefects, TellsAnInvertedSurfaceOpenOrClosed)
{
    for (TriangleMesh mesh : {unit_box(), test::tube(2e-3, 10e-3, 24, 10)}) {
        for (auto& corners : mesh.triangles)
            std::swap(corners[0], corners[1]);
        const SurfaceDefects defects = find_defects(mesh);
        EXPECT_TRUE(defects.is_inverted);
        EXPECT_FALSE(is_sound(defects));
        EXPECT_EQ(describe(defects), "the normals point into the lumen\n");
    }
}

TEST(FindDefects, DoesNotDependOnTheUnit)
{
    for (const double scale : {1e-9, 1.0, 1e6}) {
        EXPECT_TRUE(is_sound(find_defects(test::tube(2.0 * scale, 10.0 * scale, 24, 10))));
    }
}

TEST(FindDefects, OfNothingIsNotSound)
{
    EXPECT_FALSE(is_sound(find_defects(TriangleMesh{})));
}

TEST(Describe, NamesNoMoreThanFiveElements)
{
    SurfaceDefects defects;
    defects.num_components = 1;
    defects.degenerate_triangles = {1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(describe(defects), "7 degenerate triangles: 1, 2, 3, 4, 5, ...\n");
}

}  // namespace
}  // namespace braidzone
