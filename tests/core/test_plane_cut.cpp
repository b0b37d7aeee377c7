#include "core/error.hpp"
#include "core/mesh_topology.hpp"
#include "core/plane_cut.hpp"
#include "core/surface_check.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double pi = std::numbers::pi;

int num_points_in_plane(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal)
{
    return static_cast<int>(
        std::count_if(mesh.points.begin(), mesh.points.end(), [&](const Vec3& p) {
            return std::abs((p - point).dot(normal)) < 1e-15;  // points of some millimetres
        }));
}

std::string message_of(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal)
{
    try {
        cut_across(mesh, point, normal);
    } catch (const GeometryError& error) {
        return error.what();
    }
    return "";
}

// A channel of 1 x 1 x 10 cut at 4: 4 x 4 + 1 of its area stay, 4 x 6 + 1 go. The rim has a point
// on each of the four long edges and the four diagonals.
TEST(CutAcross, SplitsAChannel)
{
    const PlaneCut cut =
        cut_across(test::box(Vec3::Zero(), Vec3(1, 1, 10)), Vec3(0.4, 0.3, 4), Vec3::UnitZ());
    EXPECT_NEAR(cut.section_area, 1.0, 1e-14);
    EXPECT_NEAR(surface_area(cut.kept), 17.0, 1e-13);
    EXPECT_NEAR(surface_area(cut.removed), 25.0, 1e-13);
    const std::vector<std::vector<int>> rims = border_loops(cut.kept);
    ASSERT_EQ(rims.size(), 1u);
    EXPECT_EQ(rims[0].size(), 8u);
    EXPECT_EQ(border_loops(cut.removed).size(), 1u);
    EXPECT_TRUE(is_sound(find_defects(cut.kept)));
    EXPECT_TRUE(is_sound(find_defects(cut.removed)));
}

// A slanted plane: the section is 1 / cos larger; the pieces are prisms of mean length 4 and 6.
TEST(CutAcross, SplitsAChannelOnTheSlant)
{
    const Vec3 normal = Vec3(0.5, -0.25, 1.0).normalized();
    const PlaneCut cut =
        cut_across(test::box(Vec3::Zero(), Vec3(1, 1, 10)), Vec3(0.5, 0.5, 4), normal);
    EXPECT_NEAR(cut.section_area, 1.0 / normal.z(), 1e-13);
    EXPECT_NEAR(surface_area(cut.kept), 17.0, 1e-13);
    EXPECT_NEAR(surface_area(cut.removed), 25.0, 1e-13);
}

// The rings of the capsule's cylinder are 0.5 mm apart: the plane at 4 mm meets one.
TEST(CutAcross, RunsThroughPointsThatLieInThePlane)
{
    const TriangleMesh mesh = test::capsule(2e-3, 10e-3, 32, 20);
    for (const double direction : {1.0, -1.0}) {
        const Vec3 normal = direction * Vec3::UnitZ();
        const PlaneCut cut = cut_across(mesh, Vec3(0, 0, 4e-3), normal);
        const std::vector<std::vector<int>> rims = border_loops(cut.kept);
        ASSERT_EQ(rims.size(), 1u);
        EXPECT_EQ(rims[0].size(), 32u);  // no new points
        EXPECT_EQ(cut.kept.triangles.size() + cut.removed.triangles.size(), mesh.triangles.size());
        EXPECT_EQ(cut.kept.points.size() + cut.removed.points.size(), mesh.points.size() + 32);
        EXPECT_TRUE(is_sound(find_defects(cut.kept)));
    }
}

// Rings 0.5 mm apart with sides of 0.39 mm: at 0.03 mm from a ring its points move to the plane, at
// 0.05 mm the edges are split, each quadrilateral's one along the axis and its diagonal.
TEST(CutAcross, MovesPointsNearThePlaneOntoIt)
{
    const TriangleMesh mesh = test::capsule(2e-3, 10e-3, 32, 20);
    for (const auto& [height, num_points] :
         {std::pair{4.03e-3, 32u}, {3.97e-3, 32u}, {4.05e-3, 64u}, {3.95e-3, 64u}}) {
        const Vec3 point(0.5e-3, 0.1e-3, height);
        const PlaneCut cut = cut_across(mesh, point, Vec3::UnitZ());
        const std::vector<std::vector<int>> rims = border_loops(cut.kept);
        ASSERT_EQ(rims.size(), 1u);
        EXPECT_EQ(rims[0].size(), num_points);
        EXPECT_EQ(num_points_in_plane(cut.kept, point, Vec3::UnitZ()),
                  static_cast<int>(num_points));
        // The cylinder is a prism of 32 sides of 2 r sin(pi / 32), whatever its points' heights.
        const double perimeter = 32 * 2.0 * 2e-3 * std::sin(pi / 32);
        const double dome = surface_area(cut_across(mesh, Vec3::Zero(), Vec3::UnitZ()).kept);
        EXPECT_NEAR(surface_area(cut.kept), dome + perimeter * height, 1e-15);
        EXPECT_TRUE(is_sound(find_defects(cut.kept)));
        EXPECT_TRUE(is_sound(find_defects(cut.removed)));
    }
}

// Any plane through the middle of a sphere leaves half of it: slivers would show as defects.
TEST(CutAcross, LeavesSoundPartsInManyDirections)
{
    const TriangleMesh sphere = test::capsule(2e-3, 1e-3, 40, 2);
    for (int k = 0; k < 50; ++k) {
        const double polar = 0.1 + 0.059 * k, angle = 2.4 * k;  // the golden angle, nearly
        const Vec3 normal(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                          std::cos(polar));
        const PlaneCut cut = cut_across(sphere, Vec3(0.1e-3, 0.2e-3, 0.3e-3), normal);
        EXPECT_TRUE(is_sound(find_defects(cut.kept))) << k;
        EXPECT_TRUE(is_sound(find_defects(cut.removed))) << k;
        // Moved points shift area between the parts and bend the wall by a little.
        EXPECT_NEAR(surface_area(cut.kept) + surface_area(cut.removed), surface_area(sphere),
                    2e-3 * surface_area(sphere))
            << k;
    }
}

/// A ring-shaped tube about the z axis.
TriangleMesh torus(double axis_radius, double radius, int around, int along)
{
    TriangleMesh mesh;
    for (int k = 0; k < along; ++k) {
        const double turn = 2.0 * pi * k / along;
        for (int j = 0; j < around; ++j) {
            const double angle = 2.0 * pi * j / around;
            const double distance = axis_radius + radius * std::cos(angle);
            mesh.points.emplace_back(distance * std::cos(turn), distance * std::sin(turn),
                                     radius * std::sin(angle));
            const int next = (j + 1) % around, after = (k + 1) % along;
            const int a = k * around + j, b = k * around + next;
            const int c = after * around + next, d = after * around + j;
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
        }
    }
    return mesh;
}

TEST(CutAcross, RefusesARing)
{
    const TriangleMesh ring = torus(5e-3, 1e-3, 24, 96);
    ASSERT_TRUE(is_sound(find_defects(ring)));
    EXPECT_EQ(message_of(ring, Vec3(5e-3, 0, 0), Vec3::UnitY()),
              "cut across at (5, 0, 0) mm, the surface is still in one part: the vessel runs in a "
              "ring");
}

// In the ring's own plane the section is an annulus: beyond it the surface is in one part with what
// lies behind only through the annulus' other border.
TEST(CutAcross, RefusesASectionWithAHole)
{
    EXPECT_EQ(
        message_of(torus(5e-3, 1e-3, 24, 96), Vec3(5e-3, 0, 0.1e-3), Vec3::UnitZ()),
        "cut across at (5, 0, 0.1) mm, the surface is still in one part: the vessel runs in a "
        "ring");
}

// 0.01 mm below the tip, a point whose edges are 0.39 mm long: the tip is the whole section.
TEST(CutAcross, RefusesASectionSmallerThanATriangle)
{
    EXPECT_EQ(
        message_of(test::capsule(2e-3, 10e-3, 32, 20), Vec3(0, 0, 11.99e-3), Vec3::UnitZ()),
        "the section of the surface around (0, 0, 11.99) mm is smaller than a triangle of it");
}

TEST(CutAcross, RefusesAPointOutside)
{
    const TriangleMesh mesh = test::capsule(2e-3, 10e-3, 32, 20);
    EXPECT_EQ(message_of(mesh, Vec3(3e-3, 0, 4e-3), Vec3::UnitZ()),
              "no closed section of the surface encloses (3, 0, 4) mm");
}

}  // namespace
}  // namespace braidzone
