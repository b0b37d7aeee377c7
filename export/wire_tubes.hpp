#pragma once

#include "core/triangle_mesh.hpp"
#include "export/braid_inset.hpp"
#include "export/braid_pattern.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace braidzone {

struct WireTubeOptions {
    BraidPattern pattern;
    int facets = 8;          ///< of a wire's cross-section; >= 3
    int pieces_per_arm = 6;  ///< straight pieces between two crossings; >= 2
};

/// The wires of a deployed braid as solids: one closed tube for each, which touches no other.
struct WireTubes {
    TriangleMesh mesh;                     ///< tube after tube, normals out of the metal [m]
    std::vector<std::vector<Vec3>> lines;  ///< the middle line of each [m]
    double length = 0.0;                   ///< of the middle lines [m]
    /// Between the surfaces of two wires where they come nearest [m]; negative if they overlap.
    double least_gap = std::numeric_limits<double>::infinity();
    Vec3 least_gap_place = Vec3::Zero();  ///< [m]
    std::size_t num_overlaps = 0;         ///< pairs of straight pieces that are in one another
};

/// Half the thickness of the layer that the wires take, from the braid's surface to the outermost
/// facets [m]: a wire's diameter and a little.
double half_thickness(const WireTubeOptions& options, double wire_diameter);

/// Triangles of all tubes.
std::size_t num_wire_triangles(const BraidLattice& lattice, const WireTubeOptions& options);

/// Sweeps every wire over and under the others.
///
/// The middle line follows a Catmull-Rom spline through the wire's crossings on the deployed
/// surface (Zavodszky et al. 2020, section 2: the wires are attached to the surface coordinates) at
/// the height
///
///     z = h at crossings where the wire is outside, -h where it is inside,
///     z = (z0 + z1) / 2 + (z0 - z1) / 2 cos(pi (2 t - 1/2)) between, for t from 1/4 to 3/4,
///     h = rho + d / 40,   rho = d / 2 sqrt(2 pi / (n sin(2 pi / n)))
///
/// along the surface's normal, which leaves d / 20 between two wires that cross. Its cross-section
/// is the regular polygon of n facets with the wire's own area, whose corners lie at rho. The metal
/// is more than wire length times pi d^2 / 4 by what the wires are longer for going over and under:
/// about (pi h / a)^2 / 2 times the share of arms, of length a, between unlike
/// crossings (1 / over).
///
/// Wires of one family that are denser than their diameter, and crossings of such small angle that
/// the wires meet beside them, overlap: `num_overlaps` counts it, nothing is changed.
///
/// @param braid  the deployed braid, from the wall by `half_thickness` at least
WireTubes make_wire_tubes(const BraidLattice& lattice, const InsetBraid& braid,
                          double wire_diameter, const WireTubeOptions& options);

}  // namespace braidzone
