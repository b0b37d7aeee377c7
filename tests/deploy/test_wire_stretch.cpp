#include "deploy/wire_stretch.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

TEST(WireStretch, IsNoneInTheForceFreeDevice)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const WireStretch stretch = wire_stretch(
        test::braid_on_cylinder(device, lattice.nominal_radius, lattice.ring_spacing, 20e-3));
    EXPECT_NEAR(stretch.total, 0.0, 1e-12);
    EXPECT_NEAR(stretch.lowest, 0.0, 1e-12);
    EXPECT_NEAR(stretch.highest, 0.0, 1e-12);
}

// On a cylinder of radius R at the spacing with which the arms' chords keep their length,
// s^2 = l0^2 - (2 R sin(pi / 2n))^2, no wire is stretched however narrow it is.
TEST(WireStretch, IsNoneWhereWiresOnlyTurn)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    for (const double radius : {1.4e-3, 1.8e-3}) {
        const double chord =
            2.0 * radius * std::sin(0.5 * std::numbers::pi / lattice.nodes_per_ring);
        const double spacing = std::sqrt(lattice.arm_length * lattice.arm_length - chord * chord);
        const WireStretch stretch =
            wire_stretch(test::braid_on_cylinder(device, radius, spacing, 40e-3));
        EXPECT_NEAR(stretch.total, 0.0, 1e-12);
        EXPECT_NEAR(stretch.highest, 0.0, 1e-12);
    }
}

// All rings at twice their spacing and the radius kept: an arm is sqrt(4 s^2 + c^2) instead of
// sqrt(s^2 + c^2) long. One ring moved back by half a spacing shortens one row of arms.
TEST(WireStretch, MatchesHandCalculation)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const double s = lattice.ring_spacing;
    const double c =
        2.0 * lattice.nominal_radius * std::sin(0.5 * std::numbers::pi / lattice.nodes_per_ring);
    Deployment deployment = test::braid_on_cylinder(device, lattice.nominal_radius, 2.0 * s, 40e-3);
    const double expected = std::hypot(2.0 * s, c) / std::hypot(s, c) - 1.0;
    EXPECT_NEAR(wire_stretch(deployment).total, expected, 1e-12);
    for (int column = 0; column < lattice.nodes_per_ring; ++column)
        deployment.nodes[static_cast<std::size_t>(lattice.node(0, column))].z() -= 1.5 * s;
    EXPECT_NEAR(wire_stretch(deployment).lowest, std::hypot(0.5 * s, c) / std::hypot(s, c) - 1.0,
                1e-12);
    EXPECT_NEAR(wire_stretch(deployment).highest, expected, 1e-12);
}

}  // namespace
}  // namespace braidzone
