#include "deploy/hub_coupling.hpp"
#include "deploy/wire_network.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace braidzone {

namespace {

WireNetwork short_network()
{
    FlowDiverter device = test::pipeline_4x20();
    device.num_wires = 16;
    device.nominal_length = 4e-3;
    WireNetwork network;
    network.lattice = make_lattice(device);
    network.axial_stiffness = 2e3;
    network.bending_stiffness = 300.0;
    network.radial = {.rest_radius = 2e-3, .bending = 0.2, .torsion = 0.15, .braid_ratio = 0.4};
    return network;
}

/// The network as helices on a cylinder about z.
NetworkShape on_cylinder(const BraidLattice& lattice, double radius, double spacing)
{
    NetworkShape shape;
    shape.num_rings = lattice.num_rings;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const double angle = lattice.angle(ring, column);
            shape.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                     -ring * spacing);
        }
    }
    return shape;
}

NetworkShape disturbed(const BraidLattice& lattice)
{
    NetworkShape shape = on_cylinder(lattice, 1.8e-3, 1.3 * lattice.ring_spacing);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> shift(-5e-5, 5e-5);
    for (Vec3& node : shape.nodes)
        node += Vec3(shift(random), shift(random), shift(random));
    return shape;
}

RingRange all_of(const BraidLattice& lattice)
{
    return {0, lattice.num_rings};
}

}  // namespace

// The force-free device: arms at rest length, helices, radius R0.
TEST(WireNetwork, IsAtRestAsTheForceFreeDevice)
{
    const WireNetwork network = short_network();
    const NetworkShape shape = on_cylinder(network.lattice, 2e-3, network.lattice.ring_spacing);
    EXPECT_NEAR(network_energy(network, shape, all_of(network.lattice)), 0.0, 1e-20);
    for (const Vec3& force : network_gradient(network, shape, all_of(network.lattice)))
        EXPECT_LT(force.norm(), 1e-12);
    EXPECT_LT(largest_arm_strain(network, shape), 1e-12);
}

// Helices of any radius and spacing do not bend the wires beyond what the radial spring counts:
// with arms that bear nothing, the force on an inner node is that of its radial spring, outwards.
TEST(WireNetwork, FeelsOnlyItsRadialSpringsInAUniformTube)
{
    WireNetwork network = short_network();
    network.axial_stiffness = 0.0;
    const BraidLattice& lattice = network.lattice;
    const double radius = 1.6e-3;
    const NetworkShape shape = on_cylinder(lattice, radius, 0.4e-3);
    const std::vector<Vec3> gradient = network_gradient(network, shape, all_of(lattice));
    for (int ring = 2; ring + 2 < lattice.num_rings; ++ring) {
        const auto node = static_cast<std::size_t>(lattice.node(ring, 3));
        const Vec3 outward = Vec3(shape.nodes[node].x(), shape.nodes[node].y(), 0.0) / radius;
        const double expected = radial_force(network.radial, radius);
        EXPECT_LT((gradient[node] + expected * outward).norm(), 1e-9 * expected) << ring;
    }
}

// Central differences of the energy: second order, so that an error of 1e-6 of the largest force is
// that of the step of 1 nm against curvatures of the energy over 50 um.
TEST(NetworkGradient, IsTheDerivativeOfTheEnergy)
{
    const WireNetwork network = short_network();
    const RingRange all = all_of(network.lattice);
    NetworkShape shape = disturbed(network.lattice);
    const std::vector<Vec3> gradient = network_gradient(network, shape, all);
    double largest = 0.0;
    for (const Vec3& force : gradient)
        largest = std::max(largest, force.norm());
    const double step = 1e-9;
    for (std::size_t node : {0UL, 9UL, 20UL, 43UL, shape.nodes.size() - 1}) {
        for (int axis = 0; axis < 3; ++axis) {
            double& x = shape.nodes[node][axis];
            const double start = x;
            x = start + step;
            const double after = network_energy(network, shape, all);
            x = start - step;
            const double before = network_energy(network, shape, all);
            x = start;
            EXPECT_NEAR(gradient[node][axis], (after - before) / (2 * step), 1e-6 * largest)
                << node << " " << axis;
        }
    }
}

TEST(NetworkGradient, IsTheSameForAStretchAsForTheWhole)
{
    const WireNetwork network = short_network();
    const NetworkShape shape = disturbed(network.lattice);
    const int n = network.lattice.nodes_per_ring;
    const std::vector<Vec3> whole = network_gradient(network, shape, all_of(network.lattice));
    const std::vector<Vec3> part = network_gradient(network, shape, {3, 7});
    for (int node = 3 * n; node < 7 * n; ++node) {
        EXPECT_LT(
            (whole[static_cast<std::size_t>(node)] - part[static_cast<std::size_t>(node - 3 * n)])
                .norm(),
            1e-12)
            << node;
    }
}

// No force from within moves the network as a whole, whatever its shape.
TEST(NetworkGradient, SumsToNothing)
{
    const WireNetwork network = short_network();
    Vec3 sum = Vec3::Zero();
    double largest = 0.0;
    for (const Vec3& force :
         network_gradient(network, disturbed(network.lattice), all_of(network.lattice))) {
        sum += force;
        largest = std::max(largest, force.norm());
    }
    EXPECT_LT(sum.norm(), 1e-10 * largest);
}

// At rest no part of the second derivatives is left out, the coupling through the hubs included:
// what the matrix makes of the gradient's change is the shift that changed it.
TEST(NetworkHessian, IsTheDerivativeOfTheGradientAtRest)
{
    const WireNetwork network = short_network();
    const BraidLattice& lattice = network.lattice;
    const RingRange all = all_of(lattice);
    NetworkShape shape = on_cylinder(lattice, 2e-3, lattice.ring_spacing);

    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::vector<Vec3> pattern(shape.nodes.size());
    for (Vec3& shift : pattern)
        shift = Vec3(number(random), number(random), number(random));

    const double step = 1e-10;
    const auto gradient_at = [&](double fraction) {
        NetworkShape shifted = shape;
        for (std::size_t i = 0; i < pattern.size(); ++i)
            shifted.nodes[i] += fraction * step * pattern[i];
        return network_gradient(network, shifted, all);
    };
    const std::vector<Vec3> after = gradient_at(1.0), before = gradient_at(-1.0);
    // Nothing holds the network in space; a weak spring on every node does.
    const double hold = 1.0;
    RingBandMatrix hessian(lattice.num_rings, lattice.nodes_per_ring);
    add_network_hessian(network, shape, all, hessian);
    add_hub_coupling(network, shape, all, hessian);
    std::vector<Vec3> solved(pattern.size());
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        hessian.add(static_cast<int>(i), static_cast<int>(i), hold * Eigen::Matrix3d::Identity());
        solved[i] = (after[i] - before[i]) / (2 * step) + hold * pattern[i];
    }
    ASSERT_TRUE(hessian.solve(solved));
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        difference += (solved[i] - pattern[i]).squaredNorm();
        size += pattern[i].squaredNorm();
    }
    EXPECT_LT(std::sqrt(difference / size), 1e-4);
}

TEST(LargestArmStrain, IsThatOfTheAxialStretchByHand)
{
    const WireNetwork network = short_network();
    const BraidLattice& lattice = network.lattice;
    const NetworkShape shape = on_cylinder(lattice, 2e-3, 1.1 * lattice.ring_spacing);
    const double chord = std::sqrt(lattice.arm_length * lattice.arm_length -
                                   lattice.ring_spacing * lattice.ring_spacing);
    const double expected =
        std::hypot(chord, 1.1 * lattice.ring_spacing) / lattice.arm_length - 1.0;
    EXPECT_NEAR(largest_arm_strain(network, shape), expected, 1e-12);
}

}  // namespace braidzone
