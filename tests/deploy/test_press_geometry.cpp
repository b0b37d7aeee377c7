#include "deploy/press_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// A groove of 90 degrees, 10 mm wide: its faces fall at 45 degrees from x = 5 mm, z = 0 to the
/// bottom at z = -5 mm.
PressBench sharp_bench()
{
    PressBench bench;
    bench.edge_radius = 0.0;
    return bench;
}

}  // namespace

TEST(PressBench, HasTheDepthOfItsGroove)
{
    EXPECT_NEAR(notch_depth(sharp_bench()), 5e-3, 1e-15);
    PressBench steep = sharp_bench();
    steep.notch_angle = std::numbers::pi / 3.0;  // 60 degrees: 5 mm / tan 30 deg
    EXPECT_NEAR(notch_depth(steep), 5e-3 * std::sqrt(3.0), 1e-12);
}

TEST(DistanceToBlock, MatchesHandCalculation)
{
    const PressBench bench = sharp_bench();
    // Above the top.
    SolidDistance solid = distance_to_block(bench, 1, Vec3(8e-3, 1e-3, 2e-3));
    EXPECT_NEAR(solid.distance, 2e-3, 1e-12);
    EXPECT_LT((solid.normal - Vec3::UnitZ()).norm(), 1e-12);
    // In the middle of the groove, 5 mm / sqrt 2 from both faces.
    for (int side : {-1, 1}) {
        solid = distance_to_block(bench, side, Vec3::Zero());
        EXPECT_NEAR(solid.distance, 5e-3 / std::numbers::sqrt2, 1e-12);
        EXPECT_LT((solid.normal - Vec3(-side, 0, 1).normalized()).norm(), 1e-12);
    }
    // Inside the block, 1 mm below the top.
    EXPECT_NEAR(distance_to_block(bench, 1, Vec3(20e-3, 0, -1e-3)).distance, -1e-3, 1e-12);
}

// The rounding touches top and face; its centre is r below the top, and the edge that it replaces
// is r / cos(22.5 deg) away from it, along the bisector.
TEST(DistanceToBlock, RoundsTheEdge)
{
    PressBench bench = sharp_bench();
    bench.edge_radius = 0.5e-3;
    const double from_centre = 0.5e-3 / std::cos(std::numbers::pi / 8.0);
    const SolidDistance solid = distance_to_block(bench, 1, Vec3(5e-3, 0, 0));
    EXPECT_NEAR(solid.distance, from_centre - 0.5e-3, 1e-12);
    const double angle = 0.625 * std::numbers::pi;  // half way between 90 and 135 degrees
    EXPECT_LT((solid.normal - Vec3(std::cos(angle), 0, std::sin(angle))).norm(), 1e-9);
}

TEST(DistanceToHead, MatchesHandCalculation)
{
    PressBench bench = sharp_bench();
    // The nose's centre is 2 mm above its lowest line.
    SolidDistance solid = distance_to_head(bench, 1e-3, Vec3(0, 5e-3, 0));
    EXPECT_NEAR(solid.distance, 1e-3, 1e-12);
    EXPECT_LT((solid.normal + Vec3::UnitZ()).norm(), 1e-12);
    solid = distance_to_head(bench, 0.0, Vec3(3e-3, 0, -2e-3));  // (3, -4) mm from the centre
    EXPECT_NEAR(solid.distance, 3e-3, 1e-12);
    EXPECT_LT((solid.normal - Vec3(0.6, 0, -0.8)).norm(), 1e-12);
    bench.head = PressHead::flat;
    EXPECT_NEAR(distance_to_head(bench, 1e-3, Vec3(7e-3, 0, -2e-3)).distance, 3e-3, 1e-12);
}

}  // namespace braidzone
