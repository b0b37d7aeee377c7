#include "core/error.hpp"
#include "deploy/deployment.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/spring_forces.hpp"
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

TEST(Deploy, EndsInTheSameShapeReleasedAtOnceOrWithoutInertia)
{
    const Deployment reference = deploy_in_bulge();
    DeployOptions options;
    options.release_order = ReleaseOrder::at_once;
    EXPECT_LT(largest_shift(reference, deploy_in_bulge(options)), 1e-6);
    options = {};
    options.motion = Motion::quasi_static;
    options.residual_tolerance = 1e-5;  // without inertia, soft modes creep
    EXPECT_LT(largest_shift(reference, deploy_in_bulge(options)), 1e-6);
}

// Balance of every ring in the direction of its rays: what the springs push, the wall bears or the
// node is free and bears nothing.
TEST(Deploy, BalancesSpringForcesByContactForces)
{
    const FlowDiverter device = [] {
        FlowDiverter bulging = short_device();
        bulging.nominal_length = 8e-3;
        return bulging;
    }();
    const Deployment deployment = deploy_in_bulge({.bending_ratio = 0.0});
    const SpringCoefficients c = spring_coefficients(device, deployment.lattice, 0.0);
    double springs = 0.0, contact = 0.0;
    for (int ring = 0; ring < deployment.lattice.num_rings; ++ring) {
        for (int column = 0; column < deployment.lattice.nodes_per_ring; ++column) {
            const std::size_t i = static_cast<std::size_t>(deployment.lattice.node(ring, column));
            const Vec3 ray =
                (deployment.nodes[i] - deployment.rings[static_cast<std::size_t>(ring)].origin)
                    .normalized();
            springs += c.force_scale * ray.dot(spring_force(deployment.lattice, c, deployment.nodes,
                                                            deployment.rings, ring, column));
            contact += deployment.contact_force[i];
        }
    }
    EXPECT_GT(contact, 1e-3);
    EXPECT_NEAR(contact, springs, 0.01 * springs);
}

TEST(Deploy, RecordsShapesFromTheFirstReleaseToRest)
{
    DeployOptions options;
    options.num_frames = 9;
    const Deployment deployment = deploy_in_bulge(options);
    ASSERT_EQ(deployment.frames.size(), 9u);
    EXPECT_EQ(deployment.frames.front().step, 0);
    EXPECT_EQ(deployment.frames.front().num_released, 1);
    EXPECT_EQ(deployment.frames.back().step, deployment.steps);
    EXPECT_EQ(deployment.frames.back().num_released, deployment.lattice.num_rings);
    EXPECT_EQ(deployment.frames.back().nodes, deployment.nodes);
    EXPECT_TRUE(deploy_in_bulge().frames.empty());
}

TEST(Deploy, TellsHowTheForcesFadedAway)
{
    const Deployment deployment = deploy_in_bulge();
    ASSERT_GT(deployment.residual_history.size(), 5u);
    EXPECT_EQ(deployment.residual_history.back().step, deployment.steps);
    EXPECT_EQ(deployment.residual_history.back().residual, deployment.max_force_residual);
    EXPECT_GT(deployment.residual_history.front().residual, deployment.force_tolerance);
}

// The rings of both lattices end in the same place. Over the bulge, where the lattices' kinematics
// count, their free radii differ, see `BraidLattice`.
TEST(Deploy, GivesTheCrossingsWhateverLatticeWasDeployed)
{
    const Deployment crossings = deploy_in_bulge();
    DeployOptions options;
    options.lattice = LatticeKind::paper_2020;
    options.num_frames = 3;
    const Deployment paper = deploy_in_bulge(options);
    EXPECT_TRUE(paper.converged);
    ASSERT_EQ(paper.nodes.size(), crossings.nodes.size());
    EXPECT_EQ(paper.frames.back().nodes, paper.nodes);
    EXPECT_NEAR(paper.ring_arc_length.back(), crossings.ring_arc_length.back(), 0.06e-3);
    const WallTree wall(bulging_vessel());
    for (const Vec3& node : paper.nodes)
        EXPECT_TRUE(wall.contains(node));
    EXPECT_TRUE(inverted_rhombi(paper).empty());
}

// p = k d: the contact pressure over the undeformed wall's area, in equilibrium with the springs.
// The deployed area is larger by d / r.
TEST(Deploy, PressesACompliantWallOutByPressureOverStiffness)
{
    DeployOptions options;
    options.wall_stiffness = 1e7;
    const Deployment deployment = deploy_short(short_device(), 10e-3, options);
    ASSERT_TRUE(deployment.converged);
    for (int ring = 10; ring + 10 < deployment.lattice.num_rings; ++ring) {
        const std::size_t i = static_cast<std::size_t>(deployment.lattice.node(ring, 4));
        const double displacement = deployment.wall_displacement[i];
        EXPECT_GT(displacement, 2e-6);
        EXPECT_EQ(deployment.wall_distance[i], 0.0);
        EXPECT_TRUE(deployment.in_contact[i]);
        EXPECT_NEAR(deployment.contact_pressure[i] * (1.0 + displacement / radius),
                    options.wall_stiffness * displacement,
                    2e-3 * options.wall_stiffness * displacement);
    }
}

TEST(Deploy, LeavesARigidWallWhereItIs)
{
    const Deployment deployment = deploy_short(short_device(), 10e-3);
    for (double displacement : deployment.wall_displacement)
        EXPECT_EQ(displacement, 0.0);
}

// Free of the wall, a device with a flare and a cone rests at the radii that were set into it.
TEST(Deploy, OpensEndsToTheirOwnRadius)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 8e-3;
    device.distal_flare = 0.1e-3;
    device.proximal_flare = -0.2e-3;
    const TriangleMesh waisted = [] {
        TriangleMesh mesh = test::tube(2.6e-3, length, 96, 96);
        for (Vec3& point : mesh.points)
            point.head<2>() *=
                1.0 - 0.27 * std::exp(-std::pow((point.z() - 0.5 * length) / 0.8e-3, 2));
        return mesh;
    }();
    const Vessel vessel = make_vessel(waisted, LengthUnit{"mm", 1e-3});
    const Deployment deployment = deploy(device, test::tube_centerline(1.9e-3, length),
                                         WallTree(vessel), 10e-3, ReleaseSchedule{}, {});
    ASSERT_TRUE(deployment.converged);
    const BraidLattice& lattice = deployment.lattice;
    const auto opened = [&](int ring) {
        return (deployment.nodes[static_cast<std::size_t>(lattice.node(ring, 0))] -
                deployment.rings[static_cast<std::size_t>(ring)].origin)
            .norm();
    };
    EXPECT_NEAR(opened(0), 2.1e-3, 2e-6);
    EXPECT_NEAR(opened(lattice.num_rings - 1), 1.8e-3, 2e-6);
    EXPECT_NEAR(deployment.ring_arc_length[0] - deployment.ring_arc_length[1],
                lattice.gap_spacing(0), 1e-9);
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

// 8.5 mm at nominal spacing in 6.8 mm: the arms would be sqrt(t^2 + 1) = 1.036 dR0 long and have
// room for sqrt(t^2 + 0.64) = 0.845, so that the stiff wires fold out of their circles.
TEST(Deploy, RefusesABraidThatBucklesThroughItsHubs)
{
    FlowDiverter device = test::wire_pipeline(8.5e-3, 0.2726);
    device.nominal_length = 10e-3;
    const Vessel vessel = test::tube_vessel(3.4e-3, 20e-3);
    const Centerline line = test::tube_centerline(3.4e-3, 20e-3);
    EXPECT_THAT(message_of([&] { deploy(device, line, WallTree(vessel), 15e-3, {}, {}); }),
                testing::AllOf(HasSubstr("the braid buckles"), HasSubstr("force_free")));
    // Free to be as long as its wires are, it is sound.
    const Deployment free =
        deploy(device, test::tube_centerline(3.4e-3, 60e-3),
               WallTree(test::tube_vessel(3.4e-3, 60e-3)), 55e-3, {.sliding = 1.0}, {});
    EXPECT_TRUE(std::all_of(free.in_contact.begin(), free.in_contact.end(),
                            [](char touches) { return touches != 0; }));
}

TEST(Deploy, RefusesALumenTooNarrowForTheCatheter)
{
    FlowDiverter device = short_device();
    device.catheter_diameter = 3.8e-3;
    EXPECT_THAT(message_of([&] { deploy_short(device, 10e-3); }),
                HasSubstr("the catheter of 3.8 mm diameter does not pass"));
}

}  // namespace braidzone
