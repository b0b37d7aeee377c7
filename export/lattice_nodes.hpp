#pragma once

#include "core/vessel.hpp"
#include "porous/porous_field.hpp"

#include <cstdint>
#include <vector>

namespace braidzone {

/// What a node of a lattice-Boltzmann grid is. Outlets beyond the first count on from `outlet`:
/// 12, 13, ... (HemoFlow's numbers.)
enum class NodeType : std::uint8_t {
    unused = 0,  ///< neither fluid nor beside it
    wall = 1,    ///< solid, beside fluid
    fluid = 2,
    inlet = 10,   ///< beyond the inlet, beside fluid
    outlet = 11,  ///< beyond the first outlet, beside fluid
};

/// Whether there is fluid at a node, or an opening.
inline bool is_open(std::uint8_t type)
{
    return type >= static_cast<std::uint8_t>(NodeType::fluid);
}

/// An opening of the vessel on the lattice.
struct LatticeOpening {
    int opening = 0;        ///< index of the vessel's opening
    std::uint8_t code = 0;  ///< node type of its nodes
    std::int64_t num_nodes = 0;
};

/// A vessel with its device on the nodes of a lattice: everything that the lattice-Boltzmann
/// targets are made from. Nodes are the voxels' centres; they coincide with those of `PorousField`.
struct LatticeNodes {
    VoxelGrid grid;
    std::vector<std::uint8_t> type;        ///< of every node, see `NodeType`; x runs fastest
    std::vector<LatticeOpening> openings;  ///< the inlet first

    std::vector<std::int64_t> resisting;  ///< indices of the nodes with resistance, increasing
    std::vector<double> darcy;            ///< D along the normal [1/m^2]
    std::vector<double> forchheimer;      ///< F along the normal [1/m]
    std::vector<double> surface_density;  ///< device area per volume [1/m]
    std::vector<Vec3> normal;             ///< unit
    TangentialRatio tangential_ratio;
};

/// Beyond, a lattice is no longer for a workstation, nor an array for HemoFlow's zip without its
/// 64-bit form.
inline constexpr double most_lattice_nodes = 5e8;

/// Nodes along each axis of a lattice over the vessel, two beyond it on all sides: whole numbers,
/// of any size.
Vec3 lattice_dims(const Vessel& vessel, double spacing);

/// Lays the vessel on the field's lattice, two nodes beyond it on all sides.
///
/// A node is fluid if it lies in the lumen, and not in the plane of an opening. A node beside fluid
/// along one of the 18 links of D3Q19 is an opening's if the cap lies between them and lumen behind
/// it, else wall.
/// @param inlet  index of the vessel's opening that is the inlet; the others are outlets
/// @throws ConfigError if there would be more than 5e8 nodes, with how many, or more than 245
/// outlets
LatticeNodes make_lattice_nodes(const PorousField& field, const Vessel& vessel, int inlet);

/// Sum of D times the volume of a node [m].
double resistance_integral(const LatticeNodes& nodes);

}  // namespace braidzone
