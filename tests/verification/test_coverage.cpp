// Local geometry of a uniform braid on a cylinder against the formulas for helical wires.
//
// With N wires at the angle alpha from the axis on the radius R, each family stands at the spacing
// p = 4 pi R / N cos(alpha), and
//
//     coverage = 1 - (1 - d/p)^2,  pores per area = N^2 tan(alpha) / (8 pi^2 R^2),
//     wire length per area = 2 / p.
//
// The braid surface joins crossings by chords. Between two nodes of a ring the chord is shorter
// than the arc by (pi / n)^2 / 6 with n = N / 2, which is 0.29 % for 48 wires; so the deviation
// falls with the square of the number of wires.

#include "deploy/deployment.hpp"
#include "deploy/wire_stretch.hpp"
#include "porous/braid_surface.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace braidzone {
namespace {

constexpr double radius = 2e-3;

/// Relative deviations of one pore of the braid surface from the helix formulas.
struct Deviation {
    double coverage = 0.0;
    double pore_density = 0.0;
    double wire_length_per_area = 0.0;
    double braid_angle = 0.0;
};

Deviation deviation_from_helix(int num_wires, double angle_from_axis)
{
    FlowDiverter device = test::pipeline_4x20();
    device.num_wires = num_wires;
    // The same solidity for every number of wires: thinner wires where there are more.
    device.wire_diameter = 30e-6 * 48 / num_wires;
    device.braid_ratio = 1.0 / std::tan(angle_from_axis);
    device.nominal_length = 6e-3;
    const BraidLattice lattice = make_lattice(device);
    const BraidSurface surface = make_braid_surface(
        test::braid_on_cylinder(device, radius, lattice.ring_spacing, 6e-3), device);

    const double pi = std::numbers::pi;
    const double spacing = 4.0 * pi * radius / num_wires * std::cos(angle_from_axis);
    const double solidity = device.wire_diameter / spacing;
    const double coverage = 1.0 - (1.0 - solidity) * (1.0 - solidity);
    const double pore_density =
        num_wires * num_wires * std::tan(angle_from_axis) / (8.0 * pi * pi * radius * radius);
    const Rhombus& pore = surface.rhombi[surface.rhombi.size() / 2];
    return {pore.metal_coverage / coverage - 1.0, pore.pore_density / pore_density - 1.0,
            pore.wire_length / pore.area / (2.0 / spacing) - 1.0,
            pore.braid_angle / (0.5 * pi - angle_from_axis) - 1.0};
}

TEST(Coverage, UniformBraidAgreesWithHelixFormulasWithinTheChordError)
{
    for (const double degrees : {45.0, 60.0, 69.0, 75.0}) {
        const Deviation deviation = deviation_from_helix(48, degrees * std::numbers::pi / 180.0);
        const double chord_error = std::pow(std::numbers::pi / 24.0, 2) / 6.0;
        // The pore's area is shorter by one chord; the other figures by less than that.
        EXPECT_NEAR(deviation.pore_density, chord_error, 0.02 * chord_error) << degrees;
        EXPECT_LT(std::abs(deviation.coverage), chord_error) << degrees;
        EXPECT_LT(std::abs(deviation.wire_length_per_area), chord_error) << degrees;
        EXPECT_LT(std::abs(deviation.braid_angle), chord_error) << degrees;
    }
}

TEST(Coverage, DeviationFallsWithTheSquareOfTheNumberOfWires)
{
    const double angle = 68.2 * std::numbers::pi / 180.0;
    const std::vector<int> wires{24, 48, 96, 192};
    std::vector<Deviation> deviations;
    for (const int num_wires : wires) {
        deviations.push_back(deviation_from_helix(num_wires, angle));
    }
    for (std::size_t i = 0; i + 1 < wires.size(); ++i) {
        const Deviation &coarse = deviations[i], &fine = deviations[i + 1];
        EXPECT_NEAR(std::log2(coarse.coverage / fine.coverage), 2.0, 0.05);
        EXPECT_NEAR(std::log2(coarse.pore_density / fine.pore_density), 2.0, 0.05);
        EXPECT_NEAR(std::log2(coarse.wire_length_per_area / fine.wire_length_per_area), 2.0, 0.05);
        EXPECT_NEAR(std::log2(coarse.braid_angle / fine.braid_angle), 2.0, 0.05);
    }
}

// All metal of a device of N helical wires: N pi d^2 / 4 L / cos(alpha). The chords of 48 wires are
// shorter by less than 0.1 %.
TEST(Coverage, MetalVolumeIsThatOfTheHelicalWires)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const BraidMeasures measures = measure(make_braid_surface(
        test::braid_on_cylinder(device, radius, lattice.ring_spacing, 20e-3), device));
    const double length = (lattice.num_rings - 1) * lattice.ring_spacing;
    const double cos_alpha = std::cos(std::atan(1.0 / device.braid_ratio));
    const double cross_section =
        0.25 * std::numbers::pi * device.wire_diameter * device.wire_diameter;
    const double helical = device.num_wires * cross_section * length / cos_alpha;
    EXPECT_NEAR(measures.metal_volume, helical, 1e-3 * helical);
    EXPECT_LT(measures.metal_volume, helical);
}

// A lattice coarser than the braid knows the sheet's deformation only; the pores are those of the
// true wires under it. In a tube of radius R, released at lambda times the nominal ring spacing,
// the deformation gradient is F = diag(R / R0, lambda) around and along, and the true cell's edges
// (-+dR0, dL0) become F (-+dR0, dL0). What remains is the chord error, 0.3 % for 48 wires.
TEST(Coverage, CoarseLatticeGivesTheTrueCellUnderItsDeformation)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice true_lattice = make_lattice(device);
    constexpr double tube_radius = 1.8e-3, tube_length = 26e-3;
    const Vessel vessel = test::tube_vessel(tube_radius, tube_length, 180, 60);
    const WallTree wall(vessel);
    for (const double lambda : {1.0, 0.8}) {
        const ReleaseSchedule schedule{.windows = {{1e-3, 25e-3, lambda}}};
        DeployOptions options;
        options.lattice = LatticeKind::paper_2020;
        const Deployment deployment =
            deploy(device, test::tube_centerline(tube_radius, tube_length), wall, 23e-3, schedule,
                   options);
        ASSERT_TRUE(deployment.converged);
        const BraidSurface surface = make_braid_surface(deployment, device);
        const double around = tube_radius / true_lattice.nominal_radius * true_lattice.arm_width;
        const double along = lambda * true_lattice.ring_spacing;
        const Rhombus expected = measure_rhombus(Vec3(-around, along, 0), Vec3(around, along, 0),
                                                 device.wire_diameter, Vec3::UnitX());
        const Rhombus& pore = surface.rhombi[surface.rhombi.size() / 2];
        EXPECT_NEAR(pore.metal_coverage / expected.metal_coverage, 1.0, 0.005) << lambda;
        EXPECT_NEAR(pore.pore_density / expected.pore_density, 1.0, 0.005) << lambda;
        EXPECT_NEAR(pore.braid_angle / expected.braid_angle, 1.0, 0.005) << lambda;
    }
}

// Wires keep their length, and the device its metal, when it is released at the spacing at which it
// rests in the tube; at nominal spacing in a narrower tube the model's wires are shorter, and the
// reported stretch accounts for all that is missing.
TEST(Coverage, WireLengthAndMetalAreKeptUpToTheReportedStretch)
{
    const FlowDiverter device = test::pipeline_4x20();
    constexpr double tube_radius = 1.8e-3, tube_length = 40e-3;
    const Vessel vessel = test::tube_vessel(tube_radius, tube_length, 180, 80);
    const WallTree wall(vessel);
    const BraidLattice lattice = make_lattice(device);
    const double force_free_length =
        2.0 * lattice.nodes_per_ring * (lattice.num_rings - 1) * lattice.arm_length;
    const double cross_section =
        0.25 * std::numbers::pi * device.wire_diameter * device.wire_diameter;
    for (const double sliding : {1.0, 0.0}) {
        const Deployment deployment =
            deploy(device, test::tube_centerline(tube_radius, tube_length), wall, 36e-3,
                   ReleaseSchedule{.sliding = sliding}, {});
        ASSERT_TRUE(deployment.converged);
        const WireStretch stretch = wire_stretch(deployment);
        const BraidMeasures measures = measure(make_braid_surface(deployment, device));
        EXPECT_NEAR(measures.wire_length / force_free_length, 1.0 + stretch.total, 1e-12);
        EXPECT_NEAR(measures.metal_volume / (force_free_length * cross_section),
                    1.0 + stretch.total, 1e-12);
        if (sliding == 1.0) {
            EXPECT_NEAR(stretch.total, 0.0, 2e-3);
        }
    }
}

}  // namespace
}  // namespace braidzone
