#include "deploy/wire_bending.hpp"

namespace braidzone {

namespace {

/// r- - 2 r + r+ around a node along a wire; 0 at the wire's ends, which are free.
double second_difference(const BraidLattice& lattice, const std::vector<double>& radii, int ring,
                         int column, int column_step)
{
    if (ring <= 0 || ring >= lattice.num_rings - 1) return 0.0;
    const auto radius = [&](int offset) {
        const double value = radii[static_cast<std::size_t>(
            lattice.node(ring + offset, column + offset * column_step))];
        return lattice.rest_radii.empty() ? value : value - lattice.rest_radius(ring + offset);
    };
    return radius(-1) - 2.0 * radius(0) + radius(1);
}

}  // namespace

double bending_energy(const BraidLattice& lattice, double coefficient,
                      const std::vector<double>& radii)
{
    double energy = 0.0;
    for (int ring = 1; ring + 1 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            for (int step : lattice.arm_steps) {
                const double bend = second_difference(lattice, radii, ring, column, step);
                energy += 0.5 * coefficient * bend * bend;
            }
        }
    }
    return energy;
}

double bending_force(const BraidLattice& lattice, double coefficient,
                     const std::vector<double>& radii, int ring, int column)
{
    double force = 0.0;
    for (int step : lattice.arm_steps) {
        const auto bend = [&](int offset) {
            return second_difference(lattice, radii, ring + offset, column + offset * step, step);
        };
        force += coefficient * (2.0 * bend(0) - bend(-1) - bend(1));
    }
    return force;
}

double add_bending_forces(const BraidLattice& lattice, double coefficient,
                          const std::vector<double>& radii, std::vector<double>& forces)
{
    double energy = 0.0;
    for (int ring = 1; ring + 1 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            for (const int step : lattice.arm_steps) {
                const double bend = second_difference(lattice, radii, ring, column, step);
                const double force = coefficient * bend;
                energy += 0.5 * force * bend;
                forces[static_cast<std::size_t>(lattice.node(ring - 1, column - step))] -= force;
                forces[static_cast<std::size_t>(lattice.node(ring, column))] += 2.0 * force;
                forces[static_cast<std::size_t>(lattice.node(ring + 1, column + step))] -= force;
            }
        }
    }
    return energy;
}

}  // namespace braidzone
