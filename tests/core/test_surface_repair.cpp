#include "core/error.hpp"
#include "core/surface_check.hpp"
#include "core/surface_repair.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

using test::joined;
using test::unit_box;

/// Repairs, and expects a sound unit box, and one note that contains `note`.
void expect_unit_box(const TriangleMesh& defective, const std::string& note)
{
    EXPECT_FALSE(is_sound(find_defects(defective)));
    const auto [mesh, notes] = repair(defective, all_repairs);
    EXPECT_TRUE(is_sound(find_defects(mesh))) << describe(find_defects(mesh));
    EXPECT_NEAR(enclosed_volume(mesh), 1.0, 1e-12);
    EXPECT_NEAR(surface_area(mesh), 6.0, 1e-12);
    EXPECT_TRUE(
        std::any_of(notes.begin(), notes.end(),
                    [&](const std::string& text) { return text.find(note) != std::string::npos; }))
        << "no note of \"" << note << "\"";
}

TEST(Repair, LeavesASoundSurfaceAsItIs)
{
    const auto [mesh, notes] = repair(unit_box(), {});
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_NEAR(enclosed_volume(mesh), 1.0, 1e-14);
    EXPECT_TRUE(notes.empty());
}

TEST(Repair, DropsTrianglesWithEqualCorners)
{
    TriangleMesh mesh = unit_box();
    mesh.triangles.push_back({2, 2, 5});
    expect_unit_box(mesh, "dropped 1 triangles");
}

TEST(Repair, DropsRepeatedTriangles)
{
    TriangleMesh mesh = unit_box();
    mesh.triangles.push_back(mesh.triangles[5]);
    expect_unit_box(mesh, "dropped 1 triangles");
}

TEST(Repair, RemovesTrianglesWithoutArea)
{
    TriangleMesh mesh = unit_box();
    mesh.points.emplace_back(0.5, 0, 0);
    mesh.triangles[1] = {0, 3, 8};
    mesh.triangles.push_back({8, 3, 1});
    mesh.triangles.push_back({0, 8, 1});
    expect_unit_box(mesh, "removed 1 triangles without area");
}

TEST(Repair, TurnsATurnedTriangle)
{
    TriangleMesh mesh = unit_box();
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    expect_unit_box(mesh, "turned 1 triangles");
}

TEST(Repair, TurnsAnInvertedSurface)
{
    TriangleMesh mesh = unit_box();
    for (auto& corners : mesh.triangles)
        std::swap(corners[0], corners[1]);
    expect_unit_box(mesh, "turned all normals out of the lumen");
}

TEST(Repair, CutsOffAFin)
{
    TriangleMesh mesh = unit_box();
    mesh.points.emplace_back(0.5, -0.2, -0.2);
    mesh.triangles.push_back({0, 1, 8});
    expect_unit_box(mesh, "dropped a part of ");
}

TEST(Repair, DropsASmallPartThatHangsOnAPoint)
{
    TriangleMesh mesh = joined(unit_box(), test::box(Vec3::Ones(), Vec3::Constant(1.1)));
    for (auto& corners : mesh.triangles) {
        for (int& point : corners)
            point = point == 8 ? 7 : point;
    }
    expect_unit_box(mesh, "dropped a part of ");
}

// A point of the wall that was pushed through the opposite wall.
TEST(Repair, RemovesSelfIntersections)
{
    TriangleMesh mesh = test::tube(2e-3, 10e-3, 24, 20);
    const std::size_t middle = 24 * 10;
    mesh.points[middle].x() = -2.5e-3;
    ASSERT_FALSE(find_defects(mesh).intersecting_triangles.empty());
    const auto [repaired, notes] = repair(mesh, all_repairs);
    EXPECT_TRUE(is_sound(find_defects(repaired)));
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].find("removed self-intersections"), 0u);
    // What is left is the tube, but for the neighbourhood of that point.
    EXPECT_NEAR(surface_area(repaired), surface_area(test::tube(2e-3, 10e-3, 24, 20)),
                0.05 * surface_area(repaired));
}

TEST(Repair, GivesUpOnTwoPartsOfLikeSize)
{
    const TriangleMesh mesh =
        joined(unit_box(), test::box(Vec3::Constant(3.0), Vec3::Constant(4.0)));
    try {
        repair(mesh, all_repairs);
        FAIL() << "two boxes are no vessel";
    } catch (const GeometryError& error) {
        EXPECT_STREQ(error.what(),
                     "the surface has 2 separate parts, and the second is no small one (100 % of "
                     "the largest one's area):\n"
                     "  beside the largest: a part of 12 triangles, 1732 mm across, about (3500, "
                     "3500, 3500) mm\n"
                     "take out what is not the vessel");
    }
}

}  // namespace
}  // namespace braidzone
