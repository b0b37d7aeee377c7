#pragma once

#include "export/lattice_nodes.hpp"

namespace braidzone::test {

/// A small lattice of 3 x 4 x 5 nodes without any symmetry: node types that tell axes apart and two
/// resisting nodes, (1, 2, 3) and (2, 0, 4), with values of their own.
inline LatticeNodes asymmetric_lattice()
{
    LatticeNodes nodes;
    nodes.grid.origin = Vec3(1e-3, -2e-3, 3e-3);
    nodes.grid.spacing = 0.2e-3;
    nodes.grid.dims = {3, 4, 5};
    const std::uint8_t types[] = {0, 1, 2, 10, 11, 12, 2};
    for (std::size_t node = 0; node < nodes.grid.num_voxels(); ++node)
        nodes.type.push_back(types[(node * node + node / 3) % 7]);
    for (const std::size_t node : {nodes.grid.index(1, 2, 3), nodes.grid.index(2, 0, 4)})
        nodes.resisting.push_back(static_cast<std::int64_t>(node));
    nodes.darcy = {1.5e9, 2.5e9};
    nodes.forchheimer = {6144.0, 7168.0};
    nodes.surface_density = {5000.0, 6000.0};
    nodes.normal = {Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, -1.0)};
    return nodes;
}

}  // namespace braidzone::test
