#include "deploy/ring_centring.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

constexpr double tube_radius = 1.8e-3;
constexpr double tube_length = 12e-3;

/// The axis of the tube, moved sideways by (0.15, -0.1) mm.
Centerline centerline_beside_the_axis()
{
    Polyline line;
    for (int i = 0; i <= 12; ++i)
        line.points.emplace_back(0.15e-3, -0.1e-3, i * 1e-3);
    line.inscribed_radii.assign(line.points.size(), tube_radius - 0.18e-3);
    return resample(line);
}

std::vector<CrossSection> rings_at(double nominal_radius)
{
    const WallTree wall(test::tube_vessel(tube_radius, tube_length, 192));
    return centred_rings(centerline_beside_the_axis(), wall, {9e-3, 7.5e-3, 4e-3}, nominal_radius);
}

/// Distance from the axis of a ring in a tube of which the wall is missing, 4 mm to both sides
/// along it, for an angle `open` to both sides of one direction.
double way_into_opening(double radius, double open, double nominal_radius)
{
    TriangleMesh mesh = test::tube(radius, tube_length, 192, 60);
    std::erase_if(mesh.triangles, [&](const auto& triangle) {
        Vec3 middle = Vec3::Zero();
        for (const int point : triangle)
            middle += mesh.points[static_cast<std::size_t>(point)] / 3.0;
        return std::abs(std::atan2(middle.y(), middle.x())) < open &&
               std::abs(middle.z() - 0.5 * tube_length) < 4e-3;
    });
    // With `make_vessel` the missing wall would be a hole.
    const WallTree wall(Vessel{mesh, measured_openings(mesh), LengthUnit{"mm", 1e-3}, {}});
    const auto rings = centred_rings(test::tube_centerline(radius, tube_length), wall,
                                     {8e-3, 6e-3, 4e-3}, nominal_radius);
    return std::hypot(rings[1].origin.x(), rings[1].origin.y());
}

}  // namespace

// Angles end half way between two of the 96 directions.
//
// With the wall at r but for an angle a to both sides, d = 2 (R - r) sin a / (pi - a - sin a cos
// a), less than R - r here: the ring stays in touch with the wall behind it.
TEST(CentredRings, LieTowardsAnOpeningByTheBalanceOfTheirSprings)
{
    const double a = 43.125 * std::numbers::pi / 180.0;
    const double expected =
        2.0 * 0.1e-3 * std::sin(a) / (std::numbers::pi - a - std::sin(a) * std::cos(a));
    EXPECT_NEAR(way_into_opening(1.85e-3, a, 1.95e-3), expected, 0.01 * expected);
}

// Nearly half of the wall is missing. With w = r on the wall the balance is homogeneous in R - r
// and d: no radius of the vessel at which the ring leaves it all of a sudden.
TEST(CentredRings, MoveSteadilyAsAnOpenTubeNarrows)
{
    const double a = 84.375 * std::numbers::pi / 180.0;
    const double first = way_into_opening(1.88e-3, a, 2e-3);
    EXPECT_GT(first, 0.12e-3);
    for (const double radius : {1.92e-3, 1.9e-3, 1.86e-3, 1.84e-3, 1.82e-3}) {
        const double expected = (2e-3 - radius) / 0.12e-3 * first;
        EXPECT_NEAR(way_into_opening(radius, a, 2e-3), expected, 0.01 * expected) << radius;
    }
}

// Of 1.8 mm, about a centerline that lies 0.18 mm beside it: to first order the rings return to it,
// the next, 0.18^2 / (2 x 1.8) mm, is 9 um.
TEST(CentredRings, ReturnToTheAxisOfATube)
{
    for (const CrossSection& ring : rings_at(2e-3)) {
        EXPECT_LT(std::hypot(ring.origin.x(), ring.origin.y()), 0.02e-3);
    }
}

TEST(CentredRings, StayInTheirPlanes)
{
    const std::vector<CrossSection> rings = rings_at(2e-3);
    ASSERT_EQ(rings.size(), 3u);
    EXPECT_NEAR(rings[0].origin.z(), 9e-3, 1e-9);
    EXPECT_NEAR(rings[2].origin.z(), 4e-3, 1e-9);
}

TEST(CentredRings, StayOnTheCenterlineWhereTheyHaveRoom)
{
    for (const CrossSection& ring : rings_at(1.5e-3)) {
        EXPECT_NEAR(ring.origin.x(), 0.15e-3, 1e-9);
        EXPECT_NEAR(ring.origin.y(), -0.1e-3, 1e-9);
    }
}

}  // namespace braidzone
