#include "core/error.hpp"
#include "deploy/deployment.hpp"
#include "deploy/deployment_measures.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace braidzone {

namespace {

using testing::HasSubstr;

constexpr double radius = 1.85e-3;
constexpr double length = 12e-3;

FlowDiverter short_device()
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 6e-3;
    return device;
}

Deployment deploy_short(const FlowDiverter& device, double landing,
                        const DeployOptions& options = {}, const ReleaseSchedule& schedule = {})
{
    const Vessel vessel = test::tube_vessel(radius, length);
    return deploy(device, test::tube_centerline(radius, length), WallTree(vessel), landing,
                  schedule, options);
}

std::string message_of(const std::function<void()>& action)
{
    try {
        action();
    } catch (const GeometryError& error) {
        return error.what();
    }
    return "no GeometryError";
}

/// A tube with a wide side: the cross-section is a circle of 1.7 mm, but its half x > 0 is drawn
/// out to 2.6 mm around the middle of the tube, as a sac without a sharp neck.
Vessel bulging_vessel()
{
    TriangleMesh mesh = test::tube(1.7e-3, length, 96, 96);
    for (Vec3& point : mesh.points) {
        const double angle = std::atan2(point.y(), point.x());
        const double along = std::exp(-std::pow((point.z() - 0.5 * length) / 1.2e-3, 2));
        const double around = std::pow(std::max(0.0, std::cos(angle)), 2);
        point.head<2>() *= 1.0 + (2.6 / 1.7 - 1.0) * along * around;
    }
    return make_vessel(mesh, LengthUnit{"mm", 1e-3});
}

Deployment deploy_in_bulge(const DeployOptions& options = {}, const ReleaseSchedule& schedule = {})
{
    FlowDiverter device = short_device();
    device.nominal_length = 8e-3;
    return deploy(device, test::tube_centerline(1.7e-3, length), WallTree(bulging_vessel()), 10e-3,
                  schedule, options);
}

double largest_shift(const Deployment& a, const Deployment& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        largest = std::max(largest, (a.nodes[i] - b.nodes[i]).norm());
    }
    return largest;
}

}  // namespace

TEST(Deploy, ConvergesAndKeepsEveryNodeInTheVesselWithoutFolds)
{
    const Deployment deployment = deploy_in_bulge();
    EXPECT_TRUE(deployment.converged);
    EXPECT_LE(deployment.max_force_residual, deployment.force_tolerance);
    EXPECT_TRUE(inverted_rhombi(deployment).empty());
    const WallTree wall(bulging_vessel());
    for (const Vec3& node : deployment.nodes)
        EXPECT_TRUE(wall.contains(node));
}

TEST(Deploy, LeavesTheNodesOverTheBulgeFreeAndWithoutForce)
{
    const Deployment deployment = deploy_in_bulge();
    int num_free = 0;
    for (std::size_t i = 0; i < deployment.nodes.size(); ++i) {
        const Vec3& node = deployment.nodes[i];
        if (std::abs(node.z() - 0.5 * length) > 0.5e-3 || node.x() < 1.8e-3) continue;
        ++num_free;
        EXPECT_FALSE(deployment.in_contact[i]);
        EXPECT_EQ(deployment.contact_force[i], 0.0);
        // Wider than the tube, and no wider than the device's own radius.
        const std::size_t ring = i / static_cast<std::size_t>(deployment.lattice.nodes_per_ring);
        const double opened = (node - deployment.rings[ring].origin).norm();
        EXPECT_GT(opened, 1.75e-3);
        EXPECT_LT(opened, 2.05e-3);
    }
    EXPECT_GT(num_free, 20);
}

// Mass, time step, damping and the pace of the release shape the way to rest only. The tolerance
// leaves a node within 1e-4 c_radial R0 / c_radial = 0.2 um of rest; soft modes of many nodes leave
// a little more.
TEST(Deploy, EndsInAShapeThatDoesNotDependOnTheWayThere)
{
    const Deployment reference = deploy_in_bulge();
    EXPECT_LT(largest_shift(reference, deploy_in_bulge({.time_step_ratio = 0.2})), 1e-6);
    EXPECT_LT(largest_shift(reference, deploy_in_bulge({.damping = 0.03})), 1e-6);
    EXPECT_LT(largest_shift(reference, deploy_in_bulge({.release_interval = 25})), 1e-6);
}

TEST(Deploy, GivesTheSameBytesTwice)
{
    EXPECT_EQ(deploy_in_bulge().nodes, deploy_in_bulge().nodes);
}

// A push shortens the device by the length that the window takes up, and opens it further where it
// is free (Zavodszky et al. 2020, section 3).
TEST(Deploy, ShortensAndBulgesWhenPushed)
{
    const ReleaseSchedule push{{{.from = 5e-3, .to = 7e-3, .spacing = 0.5}}};
    const Deployment plain = deploy_in_bulge(), pushed = deploy_in_bulge({}, push);
    const auto implanted = [](const Deployment& deployment) {
        return deployment.ring_arc_length.front() - deployment.ring_arc_length.back();
    };
    EXPECT_NEAR(implanted(plain) - implanted(pushed), 2e-3, 1e-6);
    const auto furthest = [](const Deployment& deployment) {
        double x = 0.0;
        for (const Vec3& node : deployment.nodes)
            x = std::max(x, node.x());
        return x;
    };
    EXPECT_GT(furthest(pushed), furthest(plain) + 20e-6);
    EXPECT_TRUE(inverted_rhombi(pushed).empty());
}

TEST(Deploy, SaysSoIfItDoesNotConverge)
{
    const Deployment deployment = deploy_in_bulge({.max_settling_steps = 1});
    EXPECT_FALSE(deployment.converged);
    EXPECT_GT(deployment.max_force_residual, deployment.force_tolerance);
}

TEST(Deploy, RefusesADeviceThatReachesBeyondTheCenterline)
{
    EXPECT_THAT(message_of([] { deploy_short(short_device(), 5e-3); }),
                HasSubstr("which runs from 0 to 12 mm"));
    EXPECT_THAT(message_of([] { deploy_short(short_device(), 13e-3); }),
                HasSubstr("deployment.landing_distal"));
}

TEST(Deploy, RefusesADeviceThatNothingHolds)
{
    FlowDiverter device = short_device();
    device.nominal_diameter = 3.5e-3;
    EXPECT_THAT(message_of([&] { deploy_short(device, 10e-3); }), HasSubstr("3.5 mm is too small"));
}

TEST(Deploy, RefusesADeviceOfMoreThanTwiceTheDiameter)
{
    FlowDiverter device = short_device();
    device.nominal_diameter = 8e-3;
    EXPECT_THAT(message_of([&] { deploy_short(device, 10e-3); }), HasSubstr("8 mm is too large"));
}

TEST(Deploy, RefusesALumenTooNarrowForTheCatheter)
{
    FlowDiverter device = short_device();
    device.catheter_diameter = 3.8e-3;
    EXPECT_THAT(message_of([&] { deploy_short(device, 10e-3); }),
                HasSubstr("the catheter of 3.8 mm diameter does not pass"));
}

}  // namespace braidzone
