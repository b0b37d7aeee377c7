// The lattice against the closed forms of a braid of helical wires (Zavodszky et al. 2020, Figure
// 2).

#include "deploy/braid_kinematics.hpp"
#include "deploy/braid_lattice.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Ring spacing over nominal at which the arms of the lattice are force-free at a radius.
double lattice_length_ratio(int num_wires, double radius_ratio)
{
    FlowDiverter device = test::pipeline_4x20();
    device.num_wires = num_wires;
    const BraidLattice lattice = make_lattice(device);
    const double chord = 2.0 * radius_ratio * lattice.nominal_radius *
                         std::sin(0.5 * std::numbers::pi / lattice.nodes_per_ring);
    return std::sqrt(lattice.arm_length * lattice.arm_length - chord * chord) /
           lattice.ring_spacing;
}

}  // namespace

// The arms are chords of the helix: their error against the closed form falls with the square of
// the number of wires and is below 0.1 % for 48.
TEST(LatticeLength, ConvergesToTheClosedFormAsTheWiresBecomeMany)
{
    for (double radius : {0.2, 0.6, 0.9, 1.05}) {
        const double exact = length_ratio(0.40, radius);
        const double coarse = std::abs(lattice_length_ratio(24, radius) - exact);
        const double fine = std::abs(lattice_length_ratio(48, radius) - exact);
        EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05) << radius;
        EXPECT_LT(fine, 1e-3 * std::max(1.0, exact)) << radius;
    }
}

// Radius at which the arms are force-free when the rings are held at lambda times their spacing.
TEST(LatticeRadius, ConvergesToTheClosedFormAsTheWiresBecomeMany)
{
    const auto error = [](int num_wires, double lambda) {
        FlowDiverter device = test::pipeline_4x20();
        device.num_wires = num_wires;
        const BraidLattice lattice = make_lattice(device);
        const double axial = lambda * lattice.ring_spacing;
        const double chord = std::sqrt(lattice.arm_length * lattice.arm_length - axial * axial);
        const double radius =
            0.5 * chord / std::sin(0.5 * std::numbers::pi / lattice.nodes_per_ring);
        return std::abs(radius / lattice.nominal_radius - radius_ratio(0.40, lambda));
    };
    for (double lambda : {0.34, 0.7, 1.5}) {
        EXPECT_NEAR(std::log2(error(24, lambda) / error(48, lambda)), 2.0, 0.05) << lambda;
        EXPECT_LT(error(48, lambda), 2e-4) << lambda;
    }
}

}  // namespace braidzone
