#pragma once

#include "deploy/braid_lattice.hpp"

#include <array>
#include <vector>

namespace braidzone {

/// Where the nodes of one lattice lie on another of the same device, by their coordinates on the
/// device's surface: the share of the length from the distal end, and the angle (Zavodszky et al.
/// 2020, section 2: "the nodes carry continuous surface coordinates", by which the real wires are
/// attached to a coarse lattice).
///
/// Values are carried over by cubic convolution (Keys 1981, Catmull-Rom) in ring and angle: exact
/// for values that are constant or change evenly, of third order else. Radii about the hubs are
/// carried over, not places, so that a circle stays a circle.
struct LatticeMapping {
    /// A node of the fine lattice: the coarse nodes around it and their weights, which sum to 1.
    struct Stencil {
        std::array<int, 16> nodes{};
        std::array<double, 16> weights{};
    };
    std::vector<Stencil> stencils;  ///< one for each node of the fine lattice
    int num_coarse_rings = 0;
    int num_fine_rings = 0;
};

/// @param coarse  with rings of which none is turned against the others (stagger 0)
LatticeMapping make_lattice_mapping(const BraidLattice& coarse, const BraidLattice& fine);

/// Values at the fine lattice's nodes out of those at the coarse one's.
std::vector<double> carried_over(const LatticeMapping& mapping, const std::vector<double>& values);

/// Arc lengths of the fine lattice's rings out of those of the coarse one's [m], linear in between.
std::vector<double> carried_over_rings(const LatticeMapping& mapping,
                                       const std::vector<double>& arc_lengths);

/// Contact forces on the fine lattice's nodes: the pressure of the coarse lattice, carried over to
/// the nodes in contact and scaled by one factor, so that the sum of the forces stays the same.
/// @param coarse_areas, fine_areas  deployed areas of the nodes [m^2]
/// @param in_contact  of the fine lattice; if no node is, nothing bears the force and all are 0
/// @return contact forces of the fine nodes [N]
std::vector<double> carried_over_forces(const LatticeMapping& mapping,
                                        const std::vector<double>& coarse_forces,
                                        const std::vector<double>& coarse_areas,
                                        const std::vector<double>& fine_areas,
                                        const std::vector<char>& in_contact);

}  // namespace braidzone
