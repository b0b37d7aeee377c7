#include "core/centerline_compute.hpp"
#include "core/error.hpp"
#include "core/mesh_topology.hpp"
#include "core/surface_check.hpp"
#include "core/surface_opening.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace braidzone {
namespace {

const LengthUnit mm{"mm", 1e-3};
constexpr double pi = std::numbers::pi;

Vessel opened(const TriangleMesh& surface, const VesselEnds& ends)
{
    return make_vessel(surface, mm, {.ends = ends});
}

/// The opening nearest to a point.
const Opening& opening_at(const Vessel& vessel, const Vec3& point)
{
    return *std::min_element(vessel.openings.begin(), vessel.openings.end(),
                             [&](const Opening& a, const Opening& b) {
                                 return (a.centre - point).norm() < (b.centre - point).norm();
                             });
}

/// Largest distance of a rim's points from the plane through `point` across the opening.
double out_of_plane(const Vessel& vessel, const Opening& opening, const Vec3& point)
{
    double largest = 0.0;
    for (const int index : opening.rim) {
        const Vec3 arm = vessel.wall.points[static_cast<std::size_t>(index)] - point;
        largest = std::max(largest, std::abs(arm.dot(opening.normal)));
    }
    return largest;
}

std::string message_of(const TriangleMesh& surface, const VesselEnds& ends)
{
    try {
        open_rounded_ends(surface, ends);
    } catch (const GeometryError& error) {
        return error.what();
    }
    return "";
}

// A capsule of 64 sides: sections of n/2 r^2 sin(2 pi / n), between them a prism with a perimeter
// of 2 n r sin(pi / n). Cut 1 mm and 10.5 mm up a cylinder of 12 mm at points off its axis.
TEST(OpenRoundedEnds, LeavesAPrismOfACapsule)
{
    constexpr int sides = 64;
    constexpr double radius = 2e-3;
    const VesselEnds ends{Vec3(0.4e-3, -0.3e-3, 1e-3), Vec3(-0.5e-3, 0.2e-3, 10.5e-3)};
    const Vessel vessel = opened(test::capsule(radius, 12e-3, sides, 48), ends);

    ASSERT_EQ(vessel.openings.size(), 2u);
    const double area = 0.5 * sides * radius * radius * std::sin(2.0 * pi / sides);
    for (const auto& [point, outwards] :
         {std::pair<Vec3, double>{ends.from, -1.0}, {ends.to, 1.0}}) {
        const Opening& opening = opening_at(vessel, point);
        // Up to 2 degrees of tilt, as the point is off the axis: 1 / cos is 1.0006, and the centre
        // moves along the axis by 0.5 mm of tilt.
        EXPECT_GT(outwards * opening.normal.z(), std::cos(2.0 * pi / 180.0));
        EXPECT_NEAR(opening.area, area, 1e-3 * area);
        EXPECT_NEAR(opening.radius, std::sqrt(area / pi), 5e-4 * radius);
        EXPECT_NEAR((opening.centre - Vec3(0, 0, point.z())).norm(), 0.0, 0.02e-3);
        EXPECT_LT(out_of_plane(vessel, opening, point), 1e-12);
    }
    const double perimeter = 2.0 * sides * radius * std::sin(pi / sides);
    EXPECT_NEAR(surface_area(vessel.wall), perimeter * 9.5e-3, 2e-3 * perimeter * 9.5e-3);
    EXPECT_TRUE(is_sound(find_defects(vessel.wall)));
    EXPECT_EQ(vessel.notes,
              std::vector<std::string>{"cut the closed surface open at (0.4, -0.3, 1) mm and "
                                       "(-0.5, 0.2, 10.5) mm; its other ends stay closed"});
}

// Half a radius into the tips the section's radius is sqrt(1 - 1/4) r; the two zones of the domes
// that stay have 2 pi r (r / 2) each.
TEST(OpenRoundedEnds, CutsWithinTheTips)
{
    constexpr double radius = 2e-3, length = 12e-3;
    const VesselEnds ends{Vec3(0, 0, -0.5 * radius), Vec3(0, 0, length + 0.5 * radius)};
    const Vessel vessel = opened(test::capsule(radius, length, 96, 48), ends);
    ASSERT_EQ(vessel.openings.size(), 2u);
    for (const Opening& opening : vessel.openings) {
        EXPECT_NEAR(opening.radius, std::sqrt(0.75) * radius, 0.005 * radius);
    }
    const double area = 2.0 * pi * radius * (length + radius);
    EXPECT_NEAR(surface_area(vessel.wall), area, 0.003 * area);
}

/// Two legs of 10 mm along z, 8 mm apart, joined by half a ring; radius 1.5 mm.
constexpr double leg = 10e-3, bend = 4e-3;

TriangleMesh horseshoe()
{
    return test::rounded_tube(1.5e-3, 2.0 * leg + pi * bend, 48, 120, [](double s) {
        Vec3 centre, tangent;
        if (s < leg) {
            centre = Vec3(0, 0, s);
            tangent = Vec3::UnitZ();
        } else if (s > leg + pi * bend) {
            centre = Vec3(2.0 * bend, 0, 2.0 * leg + pi * bend - s);
            tangent = -Vec3::UnitZ();
        } else {
            const double angle = (s - leg) / bend;
            centre = Vec3(bend * (1.0 - std::cos(angle)), 0, leg + bend * std::sin(angle));
            tangent = Vec3(std::sin(angle), 0, std::cos(angle));
        }
        return test::Ring{centre, Vec3::UnitY().cross(tangent), Vec3::UnitY()};
    });
}

// The plane at z = 3.1 mm across the first leg goes through the second one too, which is cut at
// 1 mm only. What stays has 2 pi r times the length of its axis (Pappus).
TEST(OpenRoundedEnds, LeavesTheOtherLegOfAHorseshoeWhole)
{
    const TriangleMesh surface = horseshoe();
    const VesselEnds ends{Vec3(0.2e-3, 0.1e-3, 3.1e-3), Vec3(2.0 * bend, 0, 1e-3)};
    const Vessel vessel = opened(surface, ends);

    ASSERT_EQ(vessel.openings.size(), 2u);
    const double axis = (leg - 3.1e-3) + pi * bend + (leg - 1e-3);
    EXPECT_NEAR(surface_area(vessel.wall), 2.0 * pi * 1.5e-3 * axis,
                0.003 * 2.0 * pi * 1.5e-3 * axis);
    // Every point of the second leg above its own cut is where it was.
    const auto in_second_leg = [](const Vec3& p) {
        return p.x() > bend && p.z() > 1.5e-3 && p.z() < 9e-3;
    };
    std::vector<Vec3> before, after;
    std::copy_if(surface.points.begin(), surface.points.end(), std::back_inserter(before),
                 in_second_leg);
    std::copy_if(vessel.wall.points.begin(), vessel.wall.points.end(), std::back_inserter(after),
                 in_second_leg);
    EXPECT_GT(before.size(), 500u);
    EXPECT_EQ(before, after);
}

// Both ends at one height: the second cut's plane holds the first one's rim.
TEST(OpenRoundedEnds, CutsTwoLegsInOnePlane)
{
    const Vessel vessel = opened(horseshoe(), {Vec3(0, 0, 1e-3), Vec3(2.0 * bend, 0, 1e-3)});
    ASSERT_EQ(vessel.openings.size(), 2u);
    for (const Opening& opening : vessel.openings) {
        EXPECT_NEAR(opening.centre.z(), 1e-3, 0.02e-3);
        EXPECT_NEAR(opening.radius, 1.5e-3, 0.01e-3);
    }
}

// A tube that bends with three times its radius, cut half a radius before its tips start, 0.3
// radii off the axis.
TEST(OpenRoundedEnds, CutsABentTubeAcross)
{
    constexpr double radius = 1.5e-3, bend_radius = 3.0 * radius;
    const auto frame = [&](double s) {
        const double angle = s / bend_radius;
        const Vec3 tangent(std::cos(angle), std::sin(angle), 0);
        return test::Ring{bend_radius * Vec3(std::sin(angle), 1.0 - std::cos(angle), 0),
                          Vec3::UnitZ().cross(tangent), Vec3::UnitZ()};
    };
    const double length = 0.75 * pi * bend_radius;
    const TriangleMesh surface = test::rounded_tube(radius, length, 48, 60, frame);
    for (const double off_axis : {-0.3, 0.0, 0.3}) {
        const auto point = [&](double s) -> Vec3 {
            const test::Ring ring = frame(s);
            return ring.centre + off_axis * radius * ring.e1;
        };
        const double first = 0.5 * radius, last = length - 0.5 * radius;
        const Vessel vessel = opened(surface, {point(first), point(last)});
        ASSERT_EQ(vessel.openings.size(), 2u);
        for (const double s : {first, last}) {
            const test::Ring ring = frame(s);
            const Vec3 tangent = ring.e1.cross(ring.e2);
            const Opening& opening = opening_at(vessel, point(s));
            const double cosine = std::abs(opening.normal.dot(tangent));
            // Ten degrees would widen the opening by 1.5 %.
            EXPECT_LT(std::acos(std::min(1.0, cosine)) * 180.0 / pi, 10.0) << off_axis << " " << s;
            EXPECT_NEAR(opening.radius, radius, 0.02 * radius);
        }
    }
}

TEST(OpenRoundedEnds, LeavesACenterlineBetweenTheCuts)
{
    const VesselEnds ends{Vec3(0, 0, 1e-3), Vec3(0, 0, 10e-3)};
    const Vessel vessel = opened(test::capsule(2e-3, 12e-3, 48, 48), ends);
    const Polyline line = compute_centerline(vessel, WallTree(vessel), ends.from, ends.to);
    EXPECT_NEAR(resample(line).length(), 9e-3, 0.01e-3);
}

// A lumen of 4 x 2 mm, its openings' mean radius sqrt(2) mm: the first point lies farther out.
TEST(OpenRoundedEnds, LeavesACenterlineInAnOvalVessel)
{
    TriangleMesh mesh = test::capsule(2e-3, 12e-3, 96, 48);
    for (Vec3& p : mesh.points)
        p.y() *= 0.5;
    const VesselEnds ends{Vec3(1.6e-3, 0, 1e-3), Vec3(0, 0, 10e-3)};
    const Vessel vessel = opened(mesh, ends);
    ASSERT_EQ(vessel.openings.size(), 2u);
    for (const Opening& opening : vessel.openings)
        EXPECT_NEAR(opening.radius, std::sqrt(2.0) * 1e-3, 0.01e-3);
    const Polyline line = compute_centerline(vessel, WallTree(vessel), ends.from, ends.to);
    EXPECT_EQ(line.points.front(), ends.from);
}

TEST(OpenRoundedEnds, DoesNotTouchASurfaceThatHasOpenings)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 48, 20);
    const Vessel vessel = opened(tube, {Vec3(0, 0, 3e-3), Vec3(0, 0, 7e-3)});
    EXPECT_EQ(vessel.wall.points, tube.points);
    EXPECT_EQ(vessel.wall.triangles, tube.triangles);
    EXPECT_TRUE(vessel.notes.empty());
}

// At (2.5, 0, 5) mm the wall, a prism of 48 sides with a corner on the x axis, is 0.5 mm away.
TEST(OpenRoundedEnds, RefusesAPointOutsideTheLumen)
{
    const TriangleMesh mesh = test::capsule(2e-3, 12e-3, 48, 48);
    EXPECT_EQ(message_of(mesh, {Vec3(2.5e-3, 0, 5e-3), Vec3(0, 0, 10e-3)}),
              "the end point (2.5, 0, 5) mm is not in the lumen but 0.5 mm from the wall, outside "
              "it");
    EXPECT_EQ(message_of(mesh, {Vec3(0, 0, 1e-3), Vec3(0, 0, 15e-3)}),
              "the end point (0, 0, 15) mm is not in the lumen but 1 mm from the wall, outside it");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message_of(mesh, {Vec3(0, 0, 1e-3), Vec3(0, nan, 10e-3)}),
              "an end point of the vessel is not finite");
}

TEST(OpenRoundedEnds, RefusesTwoPointsAtOnePlace)
{
    EXPECT_THAT(
        message_of(test::capsule(2e-3, 12e-3, 48, 48), {Vec3(0, 0, 1e-3), Vec3(0, 0.3e-3, 1.4e-3)}),
        testing::StartsWith("the vessel's end points (0, 0, 1) mm and (0, 0.3, 1.4) mm are "
                            "0.5 mm apart, less than its mean radius of 1.8"));
}

// A waist of 0.001 mm radius lies between the ways of a grid of a sixth of the mean radius.
TEST(OpenRoundedEnds, RefusesEndsThatNoPathJoins)
{
    TriangleMesh mesh = test::capsule(1e-3, 10e-3, 48, 80);
    for (Vec3& p : mesh.points)
        p.head<2>() *= 1.0 - 0.999 * std::exp(-std::pow((p.z() - 5e-3) / 0.3e-3, 2));
    EXPECT_THAT(message_of(mesh, {Vec3(0.07e-3, 0.06e-3, 1e-3), Vec3(0, 0, 9e-3)}),
                testing::StartsWith("no path through the lumen joins (0.07, 0.06, 1) mm and "
                                    "(0, 0, 9) mm on a grid of 0.1"));
}

// Cut 6 mm up a cylinder of 20 mm and 1 mm radius: the tip would be 7 mm long.
TEST(OpenRoundedEnds, RefusesToTakeOffMoreThanATip)
{
    const std::string message =
        message_of(test::capsule(1e-3, 20e-3, 48, 80), {Vec3(0, 0, 6e-3), Vec3(0, 0, 19e-3)});
    EXPECT_THAT(message, testing::StartsWith("cutting at the end point (0, 0, 6) mm would take "
                                             "off 31.8 % of the surface, up to 7 mm"));
    EXPECT_THAT(message, testing::HasSubstr("stays within five radii"));
}

// A sac of 3 mm radius about the end point of a vessel of 1 mm.
TEST(OpenRoundedEnds, RefusesToCutThroughASac)
{
    TriangleMesh mesh = test::capsule(1e-3, 20e-3, 48, 160);
    for (Vec3& p : mesh.points)
        p.head<2>() *= 1.0 + 2.0 * std::exp(-std::pow((p.z() - 2e-3) / 0.4e-3, 2));
    EXPECT_THAT(message_of(mesh, {Vec3(0, 0, 2e-3), Vec3(0, 0, 19e-3)}),
                testing::StartsWith("the section across the lumen at the end point (0, 0, 2) mm is "
                                    "5.9"));
}

}  // namespace
}  // namespace braidzone
