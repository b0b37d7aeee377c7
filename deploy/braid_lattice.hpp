#pragma once

#include "deploy/flow_diverter.hpp"

#include <array>

namespace braidzone {

/// The force-free lattice of a braid: its nodes are the real crossings of the wires.
///
/// Rings of n = wires / 2 nodes follow each other at spacing dL0, each staggered by half a node
/// spacing against the one before. Ring 0 is the distal end. Node (ring k, column j) has index
/// k n + j and stands at the angle (j + k/2) 2 pi / n about the downstream axis. Its arms go to
/// (k+1, j-1), along a wire of the right-handed family, and to (k+1, j), along one of the
/// left-handed family:
///
///     dR0 = pi R0 / n,   dL0 = t dR0,   l0 = sqrt(dL0^2 + (2 R0 sin(pi / 2n))^2)
///
/// dR0 is an arc; an arm is the chord between two crossings, shorter than the piece of helix it
/// stands for by less than 0.1 % for 48 wires. With the chord in l0 the lattice is force-free at
/// R0 and dL0 exactly (Zavodszky et al. 2020, Figure 1 and Table 1; staggered so that the lattice
/// is one connected piece).
struct BraidLattice {
    int nodes_per_ring = 0;       ///< n
    int num_rings = 0;            ///< N
    double nominal_radius = 0.0;  ///< R0 [m]
    double ring_spacing = 0.0;    ///< dL0 [m]
    double arm_width = 0.0;       ///< dR0, arc between the ends of an arm [m]
    double arm_length = 0.0;      ///< l0, force-free distance between the ends of an arm [m]

    int num_nodes() const { return nodes_per_ring * num_rings; }
    int num_rhombi() const { return nodes_per_ring * (num_rings - 2); }
    /// Index of node (ring, column); the column counts round: -n to 2 n - 1 are allowed.
    int node(int ring, int column) const
    {
        const int n = nodes_per_ring;
        return ring * n + (column < 0 ? column + n : column >= n ? column - n : column);
    }
    /// Angle of node (ring, column) in the force-free device [rad].
    double angle(int ring, int column) const;
    /// Area of the device's surface that an inner node stands for, force-free [m^2]: dL0 2 dR0.
    double node_area() const { return 2.0 * ring_spacing * arm_width; }
    /// Rhombi around a node of a ring, out of four: it is the distal corner of one, the proximal of
    /// another, and at the side of two, but for the rings at the ends.
    double area_share(int ring) const
    {
        const int distal = ring + 2 < num_rings ? 1 : 0;
        const int proximal = ring >= 2 ? 1 : 0;
        const int sides = ring >= 1 && ring + 1 < num_rings ? 2 : 0;
        return 0.25 * (distal + proximal + sides);
    }
};

/// The lattice of a device: N - 1 = round(L0 / dL0) gaps, at least 2.
BraidLattice make_lattice(const FlowDiverter& device);

/// Corners of rhombus (ring k, column j), anticlockwise seen from outside: (k, j), (k+1, j-1),
/// (k+2, j-1), (k+1, j). Corners 0-1 and 3-2 lie along right-handed wires, 0-3 and 1-2 along
/// left-handed ones. k = 0 ... N-3.
std::array<int, 4> rhombus_corners(const BraidLattice& lattice, int ring, int column);

}  // namespace braidzone
