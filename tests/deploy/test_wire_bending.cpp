#include "deploy/wire_bending.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace braidzone {

namespace {

BraidLattice short_lattice()
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 1e-3;
    return make_lattice(device);
}

}  // namespace

TEST(BendingForce, VanishesForAnEvenTaper)
{
    const BraidLattice lattice = short_lattice();
    std::vector<double> radii;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        radii.insert(radii.end(), static_cast<std::size_t>(lattice.nodes_per_ring),
                     1.5e-3 + 1e-5 * ring);
    }
    EXPECT_NEAR(bending_energy(lattice, 0.3, radii), 0.0, 1e-25);
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        EXPECT_NEAR(bending_force(lattice, 0.3, radii, ring, 23), 0.0, 1e-15) << ring;
    }
}

// One node pushed out by u: on each of its two wires the second differences are u, -2 u, u, so that
// E = 2 c (1 + 4 + 1) u^2 / 2 = 6 c u^2 and F = -12 c u.
TEST(BendingForce, MatchesHandCalculationForOneNodePushedOut)
{
    const BraidLattice lattice = short_lattice();
    std::vector<double> radii(static_cast<std::size_t>(lattice.num_nodes()), 2e-3);
    const double u = 1e-5, c = 0.3;
    radii[static_cast<std::size_t>(lattice.node(5, 0))] += u;
    EXPECT_NEAR(bending_energy(lattice, c, radii), 6.0 * c * u * u, 1e-20);
    EXPECT_NEAR(bending_force(lattice, c, radii, 5, 0), -12.0 * c * u, 1e-15);
}

// The energy is quadratic, so that central differences are exact but for rounding.
TEST(BendingForce, IsMinusTheDerivativeOfTheEnergy)
{
    const BraidLattice lattice = short_lattice();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-1e-4, 1e-4);
    std::vector<double> radii(static_cast<std::size_t>(lattice.num_nodes()), 2e-3);
    for (double& radius : radii)
        radius += shift(random);
    for (int ring : {0, 1, 2, 6, lattice.num_rings - 2, lattice.num_rings - 1}) {
        for (int column : {0, 12, 23}) {
            double& radius = radii[static_cast<std::size_t>(lattice.node(ring, column))];
            const double middle = radius, step = 1e-5;
            radius = middle + step;
            const double above = bending_energy(lattice, 0.3, radii);
            radius = middle - step;
            const double below = bending_energy(lattice, 0.3, radii);
            radius = middle;
            EXPECT_NEAR(bending_force(lattice, 0.3, radii, ring, column),
                        -(above - below) / (2.0 * step), 1e-10)
                << ring << ' ' << column;
        }
    }
}

TEST(AddBendingForces, AddsWhatEachNodeBears)
{
    const BraidLattice lattice = short_lattice();
    std::mt19937 random(4);
    std::uniform_real_distribution<double> shift(-1e-4, 1e-4);
    std::vector<double> radii(static_cast<std::size_t>(lattice.num_nodes()), 2e-3);
    for (double& radius : radii)
        radius += shift(random);
    std::vector<double> forces(radii.size(), 0.5);
    const double energy = add_bending_forces(lattice, 0.3, radii, forces);
    const double expected = bending_energy(lattice, 0.3, radii);
    EXPECT_NEAR(energy, expected, 1e-13 * expected);
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const double force = forces[static_cast<std::size_t>(lattice.node(ring, column))] - 0.5;
            EXPECT_NEAR(force, bending_force(lattice, 0.3, radii, ring, column), 1e-15);
        }
    }
}

}  // namespace braidzone
