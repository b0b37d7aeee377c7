#include "core/error.hpp"
#include "deploy/axial_twist.hpp"
#include "deploy/deployment.hpp"
#include "deploy/opening_braid.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

using testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180.0;

FlowDiverter device_of(double length)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = length;
    return device;
}

/// A braid in the open whose rings are turned, at rest.
OpeningBraid free_braid(const CrimpedBraid& crimped, const FlowDiverter& device)
{
    OpeningBraid braid(crimped,
                       spring_coefficients(device, crimped.lattice, DeployOptions{}.bending_ratio),
                       {std::vector<double>(crimped.rays.size(), 4e-3)}, {});
    while (!braid.all_released())
        braid.release_next_ring();
    for (int i = 0; i < 6000; ++i)
        braid.step();
    return braid;
}

CrimpedBraid crimped_with_turns(const BraidLattice& lattice, const std::vector<double>& turns)
{
    const Centerline axis = test::tube_centerline(2e-3, 10e-3);
    std::vector<CrossSection> rings;
    for (int ring = 0; ring < lattice.num_rings; ++ring)
        rings.push_back(section_at(axis, 8e-3 - ring * lattice.ring_spacing));
    return crimp(twisted(lattice, turns), rings, 0.345e-3, turns);
}

/// Turns by x arm widths from ring to ring [rad].
std::vector<double> uniform_turns(const BraidLattice& lattice, double x)
{
    std::vector<double> turns;
    for (int ring = 0; ring < lattice.num_rings; ++ring)
        turns.push_back(ring * x * std::numbers::pi / lattice.nodes_per_ring);
    return turns;
}

std::string refusal(const std::vector<AxialTwist>& twists)
{
    try {
        validate(twists);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST(TurnAt, GoesSmoothlyFromNoneToTheWholeAngle)
{
    const std::vector<AxialTwist> twist = {{.angle = 2.0, .centre = 10e-3, .half_width = 3e-3}};
    EXPECT_EQ(turn_at(twist, 13.001e-3), 0.0);
    EXPECT_DOUBLE_EQ(turn_at(twist, 10e-3), 1.0);
    EXPECT_EQ(turn_at(twist, 6.999e-3), 2.0);
    // u = 1/4: 3/16 - 2/64 = 5/32
    EXPECT_NEAR(turn_at(twist, 11.5e-3), 2.0 * 5.0 / 32.0, 1e-12);
    EXPECT_DOUBLE_EQ(turn_at({twist[0], twist[0]}, 10e-3), 2.0);
}

// n = 24, w = 7.5 deg. x = 0.6: (1 - cos 7.5) / (1 - cos 7.5 cos 4.5) = 0.0085551 / 0.0116114,
// R = 0.85836 R0 (1 / sqrt(1.36) = 0.85749). The arms keep the mean of their squares.
TEST(AxialTwist, NarrowsAFreeBraidSoThatItsArmsKeepTheirMeanSquare)
{
    const FlowDiverter device = device_of(6e-3);
    const BraidLattice lattice = make_lattice(device);
    for (const double x : {0.6, -0.6}) {
        const CrimpedBraid crimped = crimped_with_turns(lattice, uniform_turns(lattice, x));
        const OpeningBraid braid = free_braid(crimped, device);
        for (const double radius : braid.radii())
            EXPECT_NEAR(radius, 0.85836 * 2e-3, 0.1e-6);
        double square = 0.0;
        for (const int step : lattice.arm_steps) {
            const auto first = static_cast<std::size_t>(lattice.node(20, 5));
            const auto second = static_cast<std::size_t>(lattice.node(21, 5 + step));
            square += 0.5 * (braid.nodes()[first] - braid.nodes()[second]).squaredNorm();
        }
        EXPECT_NEAR(square / (lattice.arm_length * lattice.arm_length), 1.0, 1e-4);
    }
}

// Two thirds of a half turn over 4 mm: x = 1.5 (2 pi / 3) / 4 mm t R0 = 0.628 in its middle, where
// R = R0 / sqrt(1 + x^2) = 0.847 R0 to a thousandth, and no narrowing outside.
TEST(AxialTwist, LeavesAWaistInAFreeBraid)
{
    const FlowDiverter device = device_of(7e-3);
    const BraidLattice lattice = make_lattice(device);
    std::vector<double> places;
    for (int ring = 0; ring < lattice.num_rings; ++ring)
        places.push_back(8e-3 - ring * lattice.ring_spacing);
    const std::vector<AxialTwist> twist = {{120.0 * degree, 4.5e-3, 2e-3}};
    const CrimpedBraid crimped = crimped_with_turns(lattice, ring_turns(twist, lattice, places));
    const OpeningBraid braid = free_braid(crimped, device);
    double narrowest = 2e-3;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const double radius = braid.radii()[static_cast<std::size_t>(lattice.node(ring, 7))];
        narrowest = std::min(narrowest, radius);
        if (std::abs(places[static_cast<std::size_t>(ring)] - 4.5e-3) < 2.2e-3) continue;
        EXPECT_NEAR(radius, 2e-3, 0.1e-6) << ring;
    }
    EXPECT_NEAR(narrowest / 2e-3, 0.847, 0.002);
}

TEST(Twisted, LeavesALatticeWithoutTurnsAsItIs)
{
    const BraidLattice lattice = make_lattice(device_of(6e-3));
    EXPECT_TRUE(twisted(lattice, {}).arm_lengths.empty());
    const BraidLattice same = twisted(lattice, uniform_turns(lattice, 0.0));
    for (int ring = 0; ring < lattice.num_rings; ++ring)
        EXPECT_EQ(same.rest_radius(ring), 2e-3);
    EXPECT_DOUBLE_EQ(same.rest_length(3, 0), lattice.arm_length);
    EXPECT_DOUBLE_EQ(same.rest_length(3, 1), lattice.arm_length);
}

TEST(AxialTwist, RefusesWhatNoBraidReaches)
{
    EXPECT_EQ(refusal({{1.0, 10e-3, 2e-3}}), "accepted");
    EXPECT_EQ(refusal({{14.0, 10e-3, 2e-3}}),
              "twist: angle = 802.141 deg; allowed are -720 to 720 deg");
    EXPECT_EQ(refusal({{1.0, 10e-3, 0.0}}), "twist: half_width = 0 mm; it must be positive");
    EXPECT_THAT(refusal({{1.0, std::nan(""), 1e-3}}), HasSubstr("is no place"));

    // Half a turn over 2 mm: at most 1.5 pi / 2 mm 0.10472 mm = 0.247 a ring, above pi / 24.
    const Vessel vessel = test::tube_vessel(1.85e-3, 12e-3);
    const auto deploy_twisted = [&](double half_width) {
        return deploy(device_of(6e-3), test::tube_centerline(1.85e-3, 12e-3), WallTree(vessel),
                      9e-3, {.twists = {{std::numbers::pi, 6e-3, half_width}}});
    };
    try {
        deploy_twisted(1e-3);
        FAIL() << "no ConfigError";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("below 7.5 deg"));
    }
    EXPECT_TRUE(deploy_twisted(2e-3).converged);
}

// x = 1.5 (pi / 6) / 4 mm t R0 = 0.16 would let the braid narrow to 1.975 mm: at 1.85 mm the wall
// holds it all along, and it only turns.
TEST(AxialTwist, TurnsNodesThatTheWallHolds)
{
    const Vessel vessel = test::tube_vessel(1.85e-3, 12e-3);
    const Deployment twisted =
        deploy(device_of(6e-3), test::tube_centerline(1.85e-3, 12e-3), WallTree(vessel), 9e-3,
               {.twists = {{30.0 * degree, 6e-3, 2e-3}}});
    ASSERT_TRUE(twisted.converged);
    const BraidLattice& lattice = twisted.lattice;
    for (const int ring : {0, lattice.num_rings - 1}) {
        const CrossSection& section = twisted.rings[static_cast<std::size_t>(ring)];
        const Vec3 from_hub =
            twisted.nodes[static_cast<std::size_t>(lattice.node(ring, 3))] - section.origin;
        const double angle =
            std::atan2(from_hub.dot(section.binormal), from_hub.dot(section.normal));
        const double turn = std::remainder(angle - lattice.angle(ring, 3), 2.0 * std::numbers::pi);
        EXPECT_NEAR(turn, ring == 0 ? 0.0 : 30.0 * degree, 1e-12);
        EXPECT_NEAR(from_hub.norm(), 1.85e-3, 3e-6);
    }
}

}  // namespace braidzone
