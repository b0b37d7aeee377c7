#pragma once

#include "export/lattice_nodes.hpp"
#include "porous/resistance_law.hpp"
#include "support/braids.hpp"
#include "support/shapes.hpp"

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

/// A tube along z whose openings are faces of the box, with a slanted sheet across.
struct TubeLattice {
    Vessel vessel = tube_vessel(1.5e-3, 6e-3, 96, 24);
    LatticeNodes nodes;

    /// @param a      linear constant of the sheet [Pa s/m]
    /// @param inlet  index of the vessel's opening
    explicit TubeLattice(double a = 400.0, int inlet = 0)
    {
        const BraidSurface surface = flat_braid(Vec3(-1e-3, -1e-3, 3.013e-3), Vec3(0.1e-3, 0, 0),
                                                20, Vec3(0, 0.1e-3, 0.01e-3), 20, 30e-6);
        const ResistanceSheet sheet =
            make_resistance_sheet(surface, ConstantLaw{{a, 300.0}}, Fluid{1055.0, 3.4e-3});
        nodes = make_lattice_nodes(deposit(sheet, vessel, {.spacing = 0.1e-3}), vessel, inlet);
    }
};

}  // namespace braidzone::test
