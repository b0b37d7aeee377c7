#include "deploy/braid_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

double BraidLattice::angle(int ring, int column) const
{
    return (column + 0.5 * ring) * 2.0 * std::numbers::pi / nodes_per_ring;
}

BraidLattice make_lattice(const FlowDiverter& device)
{
    validate(device);
    BraidLattice lattice;
    lattice.nodes_per_ring = device.num_wires / 2;
    lattice.nominal_radius = device.nominal_radius();
    lattice.arm_width = std::numbers::pi * lattice.nominal_radius / lattice.nodes_per_ring;
    lattice.ring_spacing = device.braid_ratio * lattice.arm_width;
    const double chord =
        2.0 * lattice.nominal_radius * std::sin(0.5 * std::numbers::pi / lattice.nodes_per_ring);
    lattice.arm_length = std::hypot(lattice.ring_spacing, chord);
    const long num_gaps = std::lround(device.nominal_length / lattice.ring_spacing);
    lattice.num_rings = static_cast<int>(std::max(num_gaps, 2L)) + 1;
    return lattice;
}

std::array<int, 4> rhombus_corners(const BraidLattice& lattice, int ring, int column)
{
    return {lattice.node(ring, column), lattice.node(ring + 1, column - 1),
            lattice.node(ring + 2, column - 1), lattice.node(ring + 1, column)};
}

}  // namespace braidzone
