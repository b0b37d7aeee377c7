#pragma once

#include "core/wall_tree.hpp"
#include "deploy/crimped_braid.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace braidzone {

/// Where the wall stops each node: the distance from the hub, along the node's ray, at which the
/// segment from the crimped position outwards first meets a triangle of the wall, less `offset`
/// measured along the wall's normal [m].
///
/// This is the whole of the contact at infinite friction (Zavodszky et al. 2020, section 2.2): a
/// node that comes to its stop is held there, does not slide, and leaves when the force along its
/// ray turns inwards. No node passes the wall, since none passes its stop.
///
/// @param reach   how far to look along the rays [m]; the stop of a ray that meets no wall so far
/// @param offset  distance from the wall at which nodes are held [m]; > 0
std::vector<double> wall_stops(const CrimpedBraid& braid, const WallTree& wall, double reach,
                               double offset);

/// What holds the nodes from outside.
struct WallSupport {
    /// |N| where nodes are held: by a rigid wall (`wall_stops`) or, before it, by jammed wires
    /// (`jam_stops`); by those alone if the wall is compliant [m].
    std::vector<double> stops;
    /// |N| force over displacement beyond the wall along the ray; empty for a rigid wall.
    std::vector<double> stiffness = {};
    /// |N| where a compliant wall begins to push back [m]; empty for a rigid one.
    std::vector<double> wall = {};

    bool is_compliant() const { return !stiffness.empty(); }

    /// How far a node at some radius has pushed a compliant wall outwards [m].
    double wall_displacement(std::size_t node, double radius) const
    {
        return is_compliant() ? std::max(0.0, radius - wall[node]) : 0.0;
    }
};

/// Stiffness of a compliant wall for each node [N/m]: `stiffness` [Pa/m] times the area of the
/// wall, undeformed, that the node covers: that of the deployed lattice with its nodes at their
/// stops, or at the nominal radius where the stop is further out.
std::vector<double> wall_stiffnesses(const CrimpedBraid& braid, const std::vector<double>& stops,
                                     double stiffness);

}  // namespace braidzone
