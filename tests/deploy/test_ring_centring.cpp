#include "deploy/ring_centring.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace

// The reach, 1.1 times the inscribed radius of 1.62 mm, is just short of the 1.8 mm of the tube: a
// ring stops where no wall is within it any more on one side only, less than 0.02 mm from the axis.
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
