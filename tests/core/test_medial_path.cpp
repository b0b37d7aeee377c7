#include "core/centerline_compute.hpp"
#include "core/medial_path.hpp"
#include "core/phantom.hpp"
#include "core/vessel.hpp"
#include "support/swept_tube.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

using std::numbers::pi;

const LengthUnit mm{"mm", 1e-3};

/// The computed centerline of a tube between its two openings, from the origin.
Centerline computed(const TriangleMesh& tube)
{
    const Vessel vessel = make_vessel(tube, mm);
    Vec3 from = vessel.openings[0].centre, to = vessel.openings[1].centre;
    if (to.norm() < from.norm()) std::swap(from, to);
    return resample(compute_centerline(vessel, WallTree(vessel), from, to), {.smoothing = 0.0});
}

double largest_distance(const Centerline& line, const Centerline& axis)
{
    double largest = 0.0;
    for (const CrossSection& section : line.sections) {
        const double place = nearest_arc_length(axis, section.origin);
        largest = std::max(largest, (section_at(axis, place).origin - section.origin).norm());
    }
    return largest;
}

// In a round tube the integral of ds / R over a bend is angle (R_b - x) / (r - |x|), which is least
// at x = 0 for R_b > r: the axis itself, of length 2 l + pi R_b.
TEST(MedialPath, IsTheAxisInATorusBend)
{
    const double radius = 1.8e-3;
    for (const double bend_radius : {2.7e-3, 4e-3, 8e-3}) {
        const std::vector<test::AxisPiece> axis = {
            test::straight(8e-3), test::bend(bend_radius, pi), test::straight(8e-3)};
        const Centerline line = computed(test::swept_tube(axis, {radius, radius}, 0.3e-3));
        const double expected = 16e-3 + pi * bend_radius;
        EXPECT_NEAR(line.length(), expected, 0.005 * expected) << bend_radius;
        for (const CrossSection& section : line.sections) {
            if (section.origin.x() < 8e-3) continue;
            const Vec3 arm = section.origin - Vec3(8e-3, bend_radius, 0.0);
            EXPECT_NEAR(arm.head<2>().norm(), bend_radius, 0.05 * radius);
            EXPECT_NEAR(arm.z(), 0.0, 0.02 * radius);
        }
    }
}

// A siphon of two opposite bends, down to 1.2 radii: the sum of its arcs and straight pieces.
TEST(MedialPath, HasTheLengthOfASiphonsAxis)
{
    const double radius = 2e-3;
    for (const double ratio : {1.2, 1.5, 2.0, 3.0}) {
        const double bend_radius = ratio * radius;
        const std::vector<test::AxisPiece> axis = {
            test::straight(8e-3), test::bend(bend_radius, 2.6), test::straight(3e-3),
            test::bend(bend_radius, -2.4), test::straight(8e-3)};
        const Centerline line = computed(test::swept_tube(axis, {radius, radius}, 0.3e-3));
        const double expected = 19e-3 + 5.0 * bend_radius;
        EXPECT_NEAR(line.length(), expected, 0.01 * expected) << ratio;
    }
}

// On the major axis of an ellipse R^2 = b^2 (1 - x^2 / c^2), so that (R_b - x) / R is least at
// x = c^2 / R_b: in a long bend the path runs on a circle of R_b - c^2 / R_b.
TEST(MedialPath, RunsOnTheInnerSideOfABendWithAnOvalSection)
{
    const double a = 2.2e-3, b = 1.8e-3;
    for (const double bend_radius : {4e-3, 6e-3, 10e-3}) {
        const Centerline line =
            computed(test::swept_tube({test::bend(bend_radius, 1.4 * pi)}, {a, b}, 0.3e-3));
        const double shift = (a * a - b * b) / bend_radius;
        // Near the ends, which stay in the middle of their openings, it is not there yet.
        for (std::size_t i = line.sections.size() / 3; i < 2 * line.sections.size() / 3; ++i) {
            const Vec3 arm = line.sections[i].origin - Vec3(0.0, bend_radius, 0.0);
            EXPECT_NEAR(arm.head<2>().norm(), bend_radius - shift, 0.01 * bend_radius);
        }
    }
}

// With its larger axis across the plane of the bend an ellipse has its sphere centres there too:
// nothing is gained by leaving the middle.
TEST(MedialPath, StaysInTheMiddleOfASectionThatIsOvalAcrossTheBend)
{
    const double bend_radius = 5e-3;
    const std::vector<test::AxisPiece> axis = {test::straight(6e-3), test::bend(bend_radius, pi),
                                               test::straight(6e-3)};
    const Centerline line = computed(test::swept_tube(axis, {1.6e-3, 2.2e-3}, 0.3e-3));
    const double expected = 12e-3 + pi * bend_radius;
    EXPECT_NEAR(line.length(), expected, 0.005 * expected);
}

// A loop whose limbs come within 0.02 mm of each other at its foot: fillets of 41 degrees lead into
// a bend of 180 + 2 * 41. By the distance of the arcs' centres cos(41 degrees) = (e + R_b) / 2 R_b.
TEST(MedialPath, GoesRoundALoopWhoseLimbsTouch)
{
    const double radius = 1e-3, gap = 0.02e-3, bend_radius = 2e-3;
    const double half_distance = radius + 0.5 * gap;
    const double turn = std::acos((half_distance + bend_radius) / (2.0 * bend_radius));
    const std::vector<test::AxisPiece> axis = {
        test::bend(bend_radius, 0.25 * pi), test::bend(bend_radius, turn),
        test::bend(bend_radius, -(pi + 2.0 * turn)), test::bend(bend_radius, turn),
        test::bend(bend_radius, 0.25 * pi)};
    const TriangleMesh tube = test::swept_tube(axis, {radius, radius}, 0.15e-3);
    const Centerline line = computed(tube);
    EXPECT_NEAR(line.length(), test::axis_length(axis), 0.01 * test::axis_length(axis));
    const WallTree wall(make_vessel(tube, mm));
    for (std::size_t i = 0; i + 1 < line.sections.size(); ++i)
        EXPECT_FALSE(wall.first_hit(line.sections[i].origin, line.sections[i + 1].origin)) << i;
}

// The mouth of a sac as wide as the vessel, on the outer side of a bend: the larger spheres there
// do not draw the path in. The phantom knows its axis.
TEST(MedialPath, DoesNotSwingIntoASac)
{
    Phantom phantom;
    phantom.segments = {{.length = 8e-3}, {.length = 8e-3, .angle = 1.6}, {.length = 8e-3}};
    phantom.sacs = {
        {.position = 12e-3, .direction = pi, .diameter = 8e-3, .height = 7e-3, .neck = 4.5e-3}};
    const PhantomVessel made = make_phantom(phantom);
    const Centerline axis = resample(made.centerline, {.smoothing = 0.0});
    const Centerline line = computed(made.wall);
    EXPECT_NEAR(line.length(), axis.length(), 0.01 * axis.length());
    EXPECT_LT(largest_distance(line, axis), 0.08 * 2e-3);
}

}  // namespace
}  // namespace braidzone
