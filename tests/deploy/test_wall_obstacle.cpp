#include "deploy/wall_obstacle.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

constexpr int sides = 12;
constexpr double radius = 2e-3;

struct Prism {
    WallTree wall{test::tube_vessel(radius, 4e-3, sides, 1)};
    Obstacle obstacle = wall_obstacle(wall);
};

}  // namespace

// The tube is a prism of twelve sides with corners at 0, 30, ... degrees; a side is cos 15 deg of
// the radius away from the axis.
TEST(WallObstacle, IsTheDistanceToThePrism)
{
    const Prism prism;
    const double apothem = radius * std::cos(std::numbers::pi / sides);
    EXPECT_NEAR(prism.obstacle.clearance(Vec3(0, 0, 1e-3)), apothem, 1e-9);
}

TEST(WallObstacle, HasAPieceForEachSideOfACrease)
{
    const Prism prism;
    std::vector<ContactPlane> planes;
    prism.obstacle.pieces(Vec3(radius - 2e-6, 0, 1.1e-3), 5e-6, planes);
    // Two sides meet there; each is of two triangles, of which this height meets one or both.
    ASSERT_GE(planes.size(), 2U);
    double lowest = 1.0, highest = -1.0;
    for (const ContactPlane& plane : planes) {
        EXPECT_NEAR(plane.gap, 2e-6 * std::cos(std::numbers::pi / sides), 1e-9);
        lowest = std::min(lowest, plane.outward.y());
        highest = std::max(highest, plane.outward.y());
    }
    EXPECT_NEAR(highest, std::sin(std::numbers::pi / sides), 1e-6);
    EXPECT_NEAR(lowest, -std::sin(std::numbers::pi / sides), 1e-6);
}

TEST(WallObstacle, StopsASegmentThatPassesIt)
{
    const Prism prism;
    const double angle = std::numbers::pi / sides;  // the middle of a side
    const Vec3 outward(std::cos(angle), std::sin(angle), 0);
    const Vec3 from(0, 0, 1e-3);
    const auto passed = prism.obstacle.passage(from, from + 3e-3 * outward);
    ASSERT_TRUE(passed.has_value());
    EXPECT_NEAR(passed->gap, radius * std::cos(angle), 1e-9);
    EXPECT_LT((passed->outward - outward).norm(), 1e-9);
    EXPECT_FALSE(prism.obstacle.passage(from, from + 1e-3 * outward).has_value());
}

}  // namespace braidzone
