#include "core/phantom.hpp"
#include "deploy/lumen_tube.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double tube_radius = 1.9e-3;
constexpr double vessel_length = 30e-3;
constexpr double reach = 8e-3;

/// A tube with a branch of 1 mm radius that leaves it at 90 degrees.
PhantomVessel branched()
{
    Phantom phantom;
    phantom.segments = {{vessel_length, 0.0, 0.0}};
    phantom.proximal_radius = phantom.distal_radius = tube_radius;
    phantom.blend_radius = 0.2e-3;
    phantom.edge_length = 0.3e-3;
    PhantomBranch branch;
    branch.position = 15e-3;
    branch.tilt = 0.5 * std::numbers::pi;
    branch.radius = 1e-3;
    branch.length = 8e-3;
    phantom.branches = {branch};
    return make_phantom(phantom);
}

TEST(TubeAlong, HasTheTubesRadius)
{
    const WallTree wall(test::tube_vessel(tube_radius, vessel_length));
    const LumenTube tube =
        tube_along(wall, test::tube_centerline(tube_radius, vessel_length), reach);
    EXPECT_NEAR(relative_distance(tube, Vec3(0.0, tube_radius, 14e-3)), 1.0, 2e-3);
    EXPECT_NEAR(relative_distance(tube, Vec3(1.5 * tube_radius, 0.0, 9e-3)), 1.5, 5e-3);
}

// The branch's axis leaves the parent's at right angles at 15 mm: all hubs lie on it, and a point
// beside it is as far off as it is from the axis, over a radius of 1 mm.
TEST(BranchTube, FollowsTheBranchToTheParent)
{
    const PhantomVessel phantom = branched();
    const Vessel vessel = make_vessel(phantom.wall, LengthUnit{"mm", 1e-3});
    const WallTree wall(vessel);
    const Centerline line = resample(phantom.centerline);
    const LumenTube parent = tube_along(wall, line, reach);
    ASSERT_EQ(vessel.openings.size(), 3U);
    const Opening& opening = vessel.openings[2];
    const Vec3 out = opening.normal;
    const Vec3 root = section_at(line, 15e-3).origin;
    const LumenTube tube = branch_tube(wall, opening, root, parent, reach);
    ASSERT_GT(tube.sections.size(), 5U);
    for (const CrossSection& section : tube.sections) {
        const Vec3 from_root = section.origin - root;
        EXPECT_LT((from_root - from_root.dot(out) * out).norm(), 0.1e-3);
        EXPECT_GT(from_root.dot(out), tube_radius - 0.05e-3);  // not in the parent
    }
    const Vec3 beside = root + 5e-3 * out + 0.7e-3 * out.unitOrthogonal();
    EXPECT_NEAR(relative_distance(tube, beside), 0.7, 0.03);
}

// The hub lies outside the lumen.
TEST(BranchTube, IsNoneWhereNoWayLeadsToTheParent)
{
    const Vessel vessel = test::tube_vessel(tube_radius, vessel_length);
    const WallTree wall(vessel);
    const LumenTube parent =
        tube_along(wall, test::tube_centerline(tube_radius, vessel_length), reach);
    EXPECT_TRUE(
        branch_tube(wall, vessel.openings[0], Vec3(0.1, 0.0, 0.0), parent, reach).sections.empty());
}

}  // namespace
}  // namespace braidzone
