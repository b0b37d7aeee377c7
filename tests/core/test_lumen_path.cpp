#include "core/lumen_path.hpp"
#include "core/phantom.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"
#include "support/swept_tube.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

const LengthUnit mm{"mm", 1e-3};

void expect_in_lumen(const std::vector<Vec3>& path, const WallTree& wall)
{
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        EXPECT_TRUE(wall.contains(path[i])) << i;
        EXPECT_FALSE(wall.first_hit(path[i], path[i + 1])) << i;
    }
}

double length_of(const std::vector<Vec3>& path)
{
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        length += (path[i + 1] - path[i]).norm();
    return length;
}

TEST(LeastCostPath, BeginsAndEndsAtTheGivenPoints)
{
    const WallTree wall(test::tube_vessel(1.8e-3, 12e-3));
    const Vec3 from(0, 0, 1e-3), to(0.2e-3, 0, 11e-3);
    for (const bool is_turned : {false, true}) {
        const Vec3 &first = is_turned ? to : from, &last = is_turned ? from : to;
        const std::vector<Vec3> path = least_cost_path(wall, first, last, 1.8e-3, 0.3e-3);
        ASSERT_FALSE(path.empty());
        EXPECT_EQ(path.front(), first);
        EXPECT_EQ(path.back(), last);
        expect_in_lumen(path, wall);
    }
}

// The wall is 0.01 mm away from both points, in a tube of 1.8 mm.
TEST(LeastCostPath, JoinsPointsBesideTheWall)
{
    const WallTree wall(test::tube_vessel(1.8e-3, 12e-3));
    const Vec3 from(1.786e-3, 0, 2e-3), to(-1.786e-3, 0, 10e-3);
    const std::vector<Vec3> path = least_cost_path(wall, from, to, 1.8e-3, 0.3e-3);
    ASSERT_FALSE(path.empty());
    expect_in_lumen(path, wall);
}

// Its mouth is narrower than a step in the middle of the artery.
TEST(LeastCostPath, FindsABranchOfAnEighthOfTheRadius)
{
    Phantom phantom;
    phantom.segments = {{.length = 14e-3}};
    phantom.branches = {
        {.position = 7e-3, .tilt = 0.5 * std::numbers::pi, .radius = 0.25e-3, .length = 5e-3}};
    phantom.blend_radius = 0.05e-3;
    phantom.edge_length = 0.15e-3;
    const WallTree wall(make_vessel(make_phantom(phantom).wall, mm));
    const Vec3 from(0.5e-3, 0, 0), to(7e-3, 4.8e-3, 0);
    const std::vector<Vec3> path = least_cost_path(wall, from, to, 2e-3, 0.25e-3 / 6.0);
    ASSERT_FALSE(path.empty());
    expect_in_lumen(path, wall);
    const std::vector<Vec3> back = least_cost_path(wall, to, from, 2e-3, 0.25e-3 / 6.0);
    EXPECT_NEAR(length_of(back), length_of(path), 0.05 * length_of(path));
}

// Two limbs of a hairpin with 0.01 mm between them: the way leads round the bend, whose inner curve
// is 0.005 mm tight.
TEST(LeastCostPath, DoesNotJumpBetweenLimbsThatTouch)
{
    const double radius = 1e-3, bend_radius = 1.005e-3;
    const double limb = 8e-3;
    const WallTree wall(make_vessel(
        test::swept_tube(
            {test::straight(limb), test::bend(bend_radius, std::numbers::pi), test::straight(limb)},
            {radius, radius}, 0.1e-3),
        mm));
    const Vec3 from(0.2e-3, 0, 0), to(0.2e-3, 2.0 * bend_radius, 0);
    const std::vector<Vec3> path = least_cost_path(wall, from, to, radius, radius / 6.0);
    ASSERT_FALSE(path.empty());
    expect_in_lumen(path, wall);
    EXPECT_GT(length_of(path), 2.0 * (limb - 0.2e-3));
}

TEST(LeastCostPath, IsEmptyIfNothingJoinsThePoints)
{
    const Vessel single = test::tube_vessel(1.8e-3, 12e-3);
    Vessel pair = single;
    TriangleMesh other = single.wall;
    for (Vec3& point : other.points)
        point.x() += 4e-3;
    pair.wall = test::joined(single.wall, other);
    const WallTree wall(pair);
    EXPECT_TRUE(
        least_cost_path(wall, Vec3(0, 0, 6e-3), Vec3(4e-3, 0, 6e-3), 1.8e-3, 0.3e-3).empty());
}

}  // namespace
}  // namespace braidzone
