#include "core/error.hpp"
#include "deploy/axial_release.hpp"
#include "deploy/braid_kinematics.hpp"
#include "deploy/deployment.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/network_deployment.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace braidzone {

namespace {

using testing::HasSubstr;

constexpr double tube_radius = 1.75e-3;
constexpr double tube_length = 12e-3;
constexpr double landing = 10e-3;

/// A coarse braid keeps the tests short: 24 wires, so that cells are twice as wide.
FlowDiverter coarse_device(double length)
{
    FlowDiverter device = test::pipeline_4x20();
    device.num_wires = 24;
    device.nominal_length = length;
    device.forces = ForceSource::wire_theory;
    device.youngs_modulus = 200e9;
    return device;
}

Deployment deploy_free(const FlowDiverter& device, double friction,
                       const ReleaseSchedule& schedule = {}, DeployOptions options = {})
{
    options.axial = AxialMotion::free;
    options.friction = friction;
    return deploy(device, test::tube_centerline(tube_radius, tube_length),
                  WallTree(test::tube_vessel(tube_radius, tube_length)), landing, schedule,
                  options);
}

double implanted_length(const Deployment& deployment)
{
    return deployment.ring_arc_length.front() - deployment.ring_arc_length.back();
}

std::string message_of(const std::function<void()>& action)
{
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

// Wires that keep their length: L = (N-1) dL0 sqrt(t^2 + 1 - (R/R0)^2) / t, whatever the friction.
// The facets of the tube and the wires' stretch make up for less than 0.5 %.
TEST(AxialRelease, ElongatesToTheClosedFormInAStraightTube)
{
    const FlowDiverter device = coarse_device(3.4e-3);
    const BraidLattice lattice = make_lattice(device);
    const double expected = lattice.ring_spacing * (lattice.num_rings - 1) *
                            length_ratio(device.braid_ratio, tube_radius / 2e-3);
    for (double friction : {0.0, 0.1, infinite_friction}) {
        const Deployment deployment = deploy_free(device, friction);
        EXPECT_TRUE(deployment.converged) << friction;
        EXPECT_NEAR(implanted_length(deployment) / expected, 1.0, 0.01) << friction;
        EXPECT_TRUE(inverted_rhombi(deployment).empty()) << friction;
    }
}

TEST(AxialRelease, StaysUniformInAStraightTube)
{
    const Deployment deployment = deploy_free(coarse_device(3.4e-3), 0.1);
    const auto& s = deployment.ring_arc_length;
    const double mean = implanted_length(deployment) / static_cast<double>(s.size() - 1);
    for (std::size_t ring = 3; ring + 4 < s.size(); ++ring)
        EXPECT_NEAR((s[ring] - s[ring + 1]) / mean, 1.0, 0.01) << ring;
}

TEST(AxialRelease, HoldsTheDistalEndWhereItLands)
{
    const Deployment deployment = deploy_free(coarse_device(3.4e-3), 0.1);
    EXPECT_NEAR(deployment.ring_arc_length.front(), landing, 0.05e-3);
}

// The force on a node of a uniform tube is that of its radial spring; the end rings bear less, and
// their neighbours what the stiffness of the wires hands on.
TEST(AxialRelease, PressesWithTheRadialSprings)
{
    const FlowDiverter device = coarse_device(3.4e-3);
    const Deployment deployment = deploy_free(device, 0.0);
    const WireNetwork network = wire_network(device, {.axial = AxialMotion::free});
    double force = 0.0, expected = 0.0;
    for (int ring = 0; ring < deployment.lattice.num_rings; ++ring) {
        for (int column = 0; column < deployment.lattice.nodes_per_ring; ++column) {
            force +=
                deployment
                    .contact_force[static_cast<std::size_t>(deployment.lattice.node(ring, column))];
            expected +=
                deployment.lattice.area_share(ring) * radial_force(network.radial, tube_radius);
        }
    }
    EXPECT_NEAR(force / expected, 1.0, 0.05);
}

TEST(AxialRelease, GivesTheSameBytesTwice)
{
    const FlowDiverter device = coarse_device(2e-3);
    EXPECT_EQ(deploy_free(device, 0.2).nodes, deploy_free(device, 0.2).nodes);
}

TEST(AxialRelease, RecordsItsFramesAndResiduals)
{
    DeployOptions options;
    options.num_frames = 4;
    const Deployment deployment = deploy_free(coarse_device(2e-3), 0.1, {}, options);
    ASSERT_EQ(deployment.frames.size(), 4U);
    EXPECT_EQ(deployment.frames.back().nodes, deployment.nodes);
    EXPECT_EQ(deployment.frames.back().num_released, deployment.lattice.num_rings);
    EXPECT_LT(deployment.frames.front().num_released, deployment.lattice.num_rings);
    EXPECT_LE(deployment.residual_history.back().residual, deployment.force_tolerance);
}

TEST(AxialRelease, RefusesADeviceThatReachesBeyondTheCenterline)
{
    const std::string message =
        message_of([] { deploy_free(coarse_device(7e-3), infinite_friction); });
    EXPECT_THAT(message, HasSubstr("beyond the proximal end of the centerline"));
    EXPECT_THAT(message, HasSubstr("take a shorter device"));
}

TEST(AxialRelease, RefusesALandingOffTheCenterline)
{
    DeployOptions options;
    options.axial = AxialMotion::free;
    const WallTree wall(test::tube_vessel(tube_radius, tube_length));
    EXPECT_THAT(message_of([&] {
                    deploy(coarse_device(2e-3), test::tube_centerline(tube_radius, tube_length),
                           wall, 13e-3, {}, options);
                }),
                HasSubstr("landing_distal = 13 mm is not on the centerline, which runs from 0 to "
                          "12 mm"));
}

TEST(AxialRelease, RefusesALumenTooNarrowForTheCatheter)
{
    FlowDiverter device = coarse_device(2e-3);
    device.catheter_diameter = 3.6e-3;
    EXPECT_THAT(message_of([&] { deploy_free(device, 0.1); }),
                HasSubstr("the catheter of 3.6 mm diameter does not pass"));
}

TEST(NetworkDeployment, RefusesWhatDoesNotGoTogether)
{
    const FlowDiverter device = coarse_device(2e-3);
    EXPECT_THAT(message_of([&] {
                    deploy_free(device, 0.1, {.windows = {{5e-3, 7e-3, 0.5}}});
                }),
                HasSubstr("deployment.push_pull"));
    const auto refusal = [&](const DeployOptions& options) {
        return message_of([&] { deploy_free(device, 0.1, {}, options); });
    };
    EXPECT_THAT(refusal({.release_order = ReleaseOrder::at_once}), HasSubstr("at_once"));
    EXPECT_THAT(refusal({.lattice = LatticeKind::paper_2020}), HasSubstr("paper-2020"));
    EXPECT_THAT(refusal({.wall_stiffness = 1e8}), HasSubstr("wall_stiffness"));
}

TEST(NetworkDeployment, NeedsTheWiresModulusForAxialFreedom)
{
    EXPECT_THAT(message_of([] { deploy_free(test::pipeline_4x20(), 0.1); }),
                HasSubstr("device.youngs_modulus"));
}

// EA / l = 200 GPa * 7.0686e-10 m^2 / 0.5640 mm = 2.5e5 N/m is capped; EI / l^3 = 200 GPa *
// 3.9761e-20 m^4 / (0.564 mm)^3 = 44.3 N/m, with l = pi 2 mm / 12 / cos(atan 0.4) = 0.5639 mm.
TEST(WireNetworkOfADevice, HasTheStiffnessOfItsWires)
{
    const WireNetwork network = wire_network(coarse_device(2e-3), {.axial = AxialMotion::free});
    EXPECT_EQ(network.axial_stiffness, 2e4);
    EXPECT_NEAR(network.bending_stiffness, 44.3, 0.1);
}

TEST(WireNetworkOfADevice, HasSurfaceSpringsForArmsWhereRingsAreLocked)
{
    FlowDiverter device = test::pipeline_4x20();
    device.force_scale = 61.0;
    const WireNetwork network = wire_network(device, {.hoop_migration = true});
    EXPECT_NEAR(network.axial_stiffness, 0.6 * 61.0, 1e-9);
    EXPECT_NEAR(network.bending_stiffness, 0.25 * 0.6 * 61.0, 1e-9);
    EXPECT_NEAR(network.radial.bending, 0.018850 * 61.0, 1e-4);
}

}  // namespace braidzone
