#include "deploy/spring_forces.hpp"
#include "deploy/wire_theory.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace braidzone {

namespace {

struct Braid {
    BraidLattice lattice;
    SpringCoefficients coefficients;
    std::vector<CrossSection> rings;
    std::vector<Vec3> nodes;
};

/// A braid of few rings around z at the given radius and ring spacing; ring 0 has the largest z.
Braid straight_braid(double radius, double spacing_ratio)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 1e-3;
    Braid braid;
    braid.lattice = make_lattice(device);
    braid.coefficients = spring_coefficients(device, braid.lattice, 0.5);
    for (int ring = 0; ring < braid.lattice.num_rings; ++ring) {
        CrossSection section;
        section.tangent = Vec3::UnitZ();
        section.normal = Vec3::UnitX();
        section.binormal = Vec3::UnitY();
        section.origin = Vec3(0, 0, -ring * spacing_ratio * braid.lattice.ring_spacing);
        braid.rings.push_back(section);
        for (int column = 0; column < braid.lattice.nodes_per_ring; ++column) {
            const double angle = braid.lattice.angle(ring, column);
            braid.nodes.push_back(section.origin +
                                  radius * Vec3(std::cos(angle), std::sin(angle), 0.0));
        }
    }
    return braid;
}

Vec3 force_on(const Braid& braid, int ring, int column)
{
    return spring_force(braid.lattice, braid.coefficients, braid.nodes, braid.rings, ring, column);
}

}  // namespace

// Reference lattice: 36 gaps of 20/36 mm, 24 nodes: 0.2909 mm^2 a node; crossing lattice:
// 0.104720 mm * 0.523599 mm = 0.054831 mm^2; 0.1 N/m * 0.054831 / 0.2909 = 0.018850 N/m.
TEST(SpringCoefficients, ScaleTheRadialSpringWithTheAreaOfItsNode)
{
    const FlowDiverter device = test::pipeline_4x20();
    const SpringCoefficients c = spring_coefficients(device, make_lattice(device), 0.5);
    EXPECT_DOUBLE_EQ(c.surface, 0.6);
    EXPECT_NEAR(c.radial.bending, 0.018850, 1e-6);
    EXPECT_DOUBLE_EQ(c.bending, 0.3);
}

// The real radial spring of a crossing has the stiffness c_bending + c_torsion / t^2, and an arm
// 0.6 / 0.018850 = 31.831 times that.
TEST(SpringCoefficients, AreInNewtonsWithWireTheoryTimesTheForceScale)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    const SpringCoefficients c = spring_coefficients(device, make_lattice(device), 0.5);
    const RadialSpring real = crossing_radial_spring(device);
    EXPECT_DOUBLE_EQ(c.surface, 0.6);
    EXPECT_DOUBLE_EQ(c.bending, 0.3);
    EXPECT_NEAR(c.radial.bending * c.force_scale, real.bending, 1e-12 * real.bending);
    EXPECT_NEAR(c.radial.torsion * c.force_scale, real.torsion, 1e-12 * real.torsion);
    EXPECT_DOUBLE_EQ(c.radial.braid_ratio, 0.40);
    EXPECT_NEAR(c.surface * c.force_scale, 31.831 * radial_stiffness(real),
                1e-3 * radial_stiffness(real));
}

// A device with springs of its own keeps their ratio and their size: 0.4 N/m, and at a crossing of
// (0.35 pi 2.5 mm / 24) (2 pi 2.5 mm / 24) = 0.0749651 mm^2 out of 0.363610 mm^2, 0.0164935 N/m.
TEST(SpringCoefficients, KeepTheRatioOfTheDevicesOwnSpringsWithWireTheory)
{
    FlowDiverter device = test::pipeline_5x20();
    device.forces = ForceSource::wire_theory;
    device.youngs_modulus = 200e9;
    const SpringCoefficients c = spring_coefficients(device, make_lattice(device), 0.5);
    EXPECT_DOUBLE_EQ(c.surface, 0.4);
    EXPECT_NEAR(c.surface / radial_stiffness(c.radial), 0.4 / 0.0164935, 1e-3);
}

// A node of a coarser lattice stands for more of the wires.
TEST(SpringCoefficients, ScaleWireTheoryWithTheAreaOfTheNode)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    BraidLattice coarse = make_lattice(device);
    const SpringCoefficients fine = spring_coefficients(device, coarse, 0.5);
    coarse.nodes_per_ring /= 2;
    coarse.arm_width *= 2.0;
    coarse.ring_spacing *= 2.0;
    coarse.arm_length *= 2.0;
    const SpringCoefficients c = spring_coefficients(device, coarse, 0.5);
    EXPECT_DOUBLE_EQ(c.force_scale, fine.force_scale);
    EXPECT_DOUBLE_EQ(c.surface, fine.surface);
    EXPECT_NEAR(c.radial.bending, 4.0 * fine.radial.bending, 1e-12 * c.radial.bending);
    EXPECT_NEAR(c.radial.torsion, 4.0 * fine.radial.torsion, 1e-12 * c.radial.torsion);
}

TEST(SpringForce, VanishesInTheForceFreeDevice)
{
    const Braid braid = straight_braid(2e-3, 1.0);
    for (int ring = 0; ring < braid.lattice.num_rings; ++ring) {
        EXPECT_LT(force_on(braid, ring, 3).norm(), 1e-15) << ring;
    }
}

// Radial force of an inner node at radius R and nominal spacing, by the geometry of its four arms:
// c_radial (R0 - R) + 4 c_surface (l0 - l) R (1 - cos(pi/n)) / l.
TEST(SpringForce, MatchesTheClosedFormInAStraightTube)
{
    const double radius = 1.85e-3;
    const Braid braid = straight_braid(radius, 1.0);
    const double half_angle = std::numbers::pi / braid.lattice.nodes_per_ring;
    const double length =
        std::hypot(braid.lattice.ring_spacing, 2.0 * radius * std::sin(0.5 * half_angle));
    const double expected = braid.coefficients.radial.bending * (2e-3 - radius) +
                            4.0 * braid.coefficients.surface * (braid.lattice.arm_length - length) *
                                radius * (1.0 - std::cos(half_angle)) / length;
    const Vec3 outward =
        (braid.nodes[static_cast<std::size_t>(braid.lattice.node(4, 3))] - braid.rings[4].origin)
            .normalized();
    EXPECT_NEAR(force_on(braid, 4, 3).dot(outward), expected, 1e-12 * expected);
    EXPECT_NEAR(force_on(braid, 4, 3).cross(outward).norm(), 0.0, 1e-15);
}

// A lattice of aligned rings whose cells are twice as wide and as long as those of the crossings,
// of which there are two for each node: the same sheet, so the same pressure. Chords of 15 instead
// of 7.5 degrees leave 0.3 % of a length.
TEST(SpringCoefficients, MakeLatticesOfOtherCellsEquallyStiff)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice crossings = make_lattice(device);
    BraidLattice wide = crossings;
    wide.stagger = 0.0;
    wide.arm_steps = {-1, 1};
    wide.arm_width = 2.0 * crossings.arm_width;
    wide.ring_spacing = 2.0 * crossings.ring_spacing;
    wide.arm_length = std::hypot(wide.ring_spacing, 4e-3 * std::sin(std::numbers::pi / 24));
    const auto pressure = [&](const BraidLattice& lattice) {
        const double radius = 1.85e-3, angle = lattice.arm_width / lattice.nominal_radius;
        const SpringCoefficients c = spring_coefficients(device, lattice, 0.0);
        const double length =
            std::hypot(lattice.ring_spacing, 2.0 * radius * std::sin(0.5 * angle));
        const double force =
            c.radial.bending * (2e-3 - radius) + 4.0 * c.surface * (lattice.arm_length - length) *
                                                     radius * (1.0 - std::cos(angle)) / length;
        return force / lattice.node_area();
    };
    EXPECT_NEAR(pressure(wide), pressure(crossings), 0.005 * pressure(crossings));
}

// A = 20 mm / 36 pi 4 mm / 24 = 0.290888 mm^2 and l0 = 1.666147 mm against 0.054831 mm^2 and
// 0.281966 mm: 0.6 N/m 5.30516 / 5.90903^2 = 0.091163 N/m.
TEST(SpringCoefficients, SoftenTheLongArmsOfThePapersLattice)
{
    const FlowDiverter device = test::pipeline_4x20();
    const SpringCoefficients c =
        spring_coefficients(device, make_lattice(device, LatticeKind::paper_2020), 0.5);
    EXPECT_NEAR(c.surface, 0.091163, 2e-4);
    EXPECT_NEAR(c.radial.bending, 0.1, 1e-6);
}

// The radial springs of a ring and its hub are one system: energy against the place of the hub.
TEST(HubForce, IsMinusTheGradientOfTheEnergyInThePlaneOfTheRing)
{
    Braid braid = straight_braid(1.7e-3, 0.8);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> shift(-4e-5, 4e-5);
    for (Vec3& node : braid.nodes)
        node += Vec3(shift(random), shift(random), 0.0);
    for (int ring : {0, 4}) {
        CrossSection& section = braid.rings[static_cast<std::size_t>(ring)];
        section.origin += Vec3(5e-5, -3e-5, 0.0);
        const Vec3 force =
            hub_force(braid.lattice, braid.coefficients, braid.nodes, braid.rings, ring);
        EXPECT_EQ(force.z(), 0.0);
        for (int axis = 0; axis < 2; ++axis) {
            const double x = section.origin[axis], step = 1e-6;
            const auto energy_at = [&](double value) {
                section.origin[axis] = value;
                return elastic_energy(braid.lattice, braid.coefficients, braid.nodes, braid.rings);
            };
            const double slope = (energy_at(x + step) - energy_at(x - step)) / (2.0 * step);
            section.origin[axis] = x;
            EXPECT_NEAR(force[axis], -slope, 1e-6 * force.norm()) << ring;
        }
    }
}

namespace {

// Central differences of the energy: their error is of second order in the step, so that it falls
// by four when the step is halved.
void expect_force_minus_gradient(Braid braid)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-2e-5, 2e-5);
    for (Vec3& node : braid.nodes)
        node += Vec3(shift(random), shift(random), shift(random));

    const auto largest_error = [&](double step) {
        double largest = 0.0;
        for (int ring : {0, 1, 5, braid.lattice.num_rings - 1}) {
            for (int column : {0, 11, 23}) {
                const Vec3 force = force_on(braid, ring, column);
                Vec3& node =
                    braid.nodes[static_cast<std::size_t>(braid.lattice.node(ring, column))];
                for (int axis = 0; axis < 3; ++axis) {
                    const double x = node[axis];
                    const auto energy_at = [&](double value) {
                        node[axis] = value;
                        return elastic_energy(braid.lattice, braid.coefficients, braid.nodes,
                                              braid.rings);
                    };
                    const double slope = (energy_at(x + step) - energy_at(x - step)) / (2.0 * step);
                    node[axis] = x;
                    largest = std::max(largest, std::abs(force[axis] + slope));
                }
            }
        }
        return largest;
    };
    const double coarse = largest_error(2e-5), fine = largest_error(1e-5);
    EXPECT_NEAR(coarse / fine, 4.0, 0.2);
    EXPECT_LT(fine, 1e-3 * 0.6 * braid.lattice.arm_length);
}

}  // namespace

TEST(SpringForce, IsMinusTheGradientOfTheEnergy)
{
    expect_force_minus_gradient(straight_braid(1.7e-3, 0.8));
}

// Arms of each family and gap with their own lengths, as in a twisted braid.
TEST(SpringForce, IsMinusTheGradientOfTheEnergyWithUnlikeArms)
{
    Braid braid = straight_braid(1.7e-3, 0.8);
    for (int ring = 0; ring + 1 < braid.lattice.num_rings; ++ring) {
        braid.lattice.arm_lengths.push_back({(0.95 + 0.01 * ring) * braid.lattice.arm_length,
                                             (1.05 - 0.005 * ring) * braid.lattice.arm_length});
    }
    expect_force_minus_gradient(braid);
}

// sqrt((8 * 0.6 + 0.1 + 32 * 0.3) / 2) by hand.
TEST(LargestFrequency, BoundsTheStiffnessOfArmsRadialSpringAndWires)
{
    EXPECT_DOUBLE_EQ(
        largest_frequency(
            {.surface = 0.6,
             .radial = {.rest_radius = 2e-3, .bending = 0.1, .torsion = 0.0, .braid_ratio = 0.4},
             .bending = 0.3},
            2.0),
        std::sqrt(14.5 / 2.0));
}

// With rest lengths and radii of its own for each ring, as those of a flare and a twist.
TEST(AddSpringForces, AddsWhatEachNodeBears)
{
    Braid braid = straight_braid(1.8e-3, 0.9);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(-0.1, 0.1);
    for (Vec3& node : braid.nodes)
        node += 1e-4 * Vec3(share(random), share(random), share(random));
    for (int ring = 0; ring < braid.lattice.num_rings; ++ring) {
        braid.lattice.rest_radii.push_back(2e-3 * (1.0 + share(random)));
        braid.lattice.arm_lengths.push_back({braid.lattice.arm_length * (1.0 + share(random)),
                                             braid.lattice.arm_length * (1.0 + share(random))});
    }
    const Vec3 before(1.0, -2.0, 3.0);
    std::vector<Vec3> forces(braid.nodes.size(), before);
    const double energy =
        add_spring_forces(braid.lattice, braid.coefficients, braid.nodes, braid.rings, forces);
    const double expected =
        elastic_energy(braid.lattice, braid.coefficients, braid.nodes, braid.rings);
    EXPECT_NEAR(energy, expected, 1e-13 * expected);
    for (int ring = 0; ring < braid.lattice.num_rings; ++ring) {
        for (int column = 0; column < braid.lattice.nodes_per_ring; ++column) {
            const auto node = static_cast<std::size_t>(braid.lattice.node(ring, column));
            // The forces are about 1e-5 N; rounding is that of the 1 N that was there before.
            EXPECT_LT((forces[node] - before - force_on(braid, ring, column)).norm(), 1e-14);
        }
    }
}

}  // namespace braidzone
