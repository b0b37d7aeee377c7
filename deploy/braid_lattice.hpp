#pragma once

#include "deploy/deploy_options.hpp"
#include "deploy/flow_diverter.hpp"

#include <array>
#include <numbers>
#include <vector>

namespace braidzone {

/// The force-free lattice of a braid.
///
/// Rings of n = wires / 2 nodes follow each other at spacing dL0, each turned by `stagger` node
/// spacings against the one before. Ring 0 is the distal end. Node (ring k, column j) has index
/// k n + j and stands at the angle (j + stagger k) 2 pi / n about the downstream axis. Its arms go
/// to the columns j + arm_steps[0] of ring k+1, along a wire of the right-handed family, and
/// j + arm_steps[1], along one of the left-handed family.
///
/// The crossings of the wires, the lattice that every result is given on, have stagger 1/2 and arms
/// to (k+1, j-1) and (k+1, j):
///
///     dR0 = pi R0 / n,   dL0 = t dR0,   l0 = sqrt(dL0^2 + (2 R0 sin(pi / 2n))^2)
///
/// dR0 is an arc; an arm is the chord between two crossings, shorter than the piece of helix it
/// stands for by less than 0.1 % for 48 wires. With the chord in l0 the lattice is force-free at
/// R0 and dL0 exactly (Zavodszky et al. 2020, Figure 1 and Table 1; staggered so that the lattice
/// is one connected piece).
///
/// The coarse lattice of that paper, as far as it can be told from surfaces that its authors made,
/// has 37 rings without stagger, arms to (k+1, j-3) and (k+1, j+3), and the arc in l0:
///
///     dR0 = 3 2 pi R0 / n,   dL0 = L0 / 36,   l0 = sqrt(dL0^2 + dR0^2)
///
/// A node's neighbours have the other parity of k + j, so that for even n the lattice is two
/// halves that no arm connects. With arcs for chords of 45 degrees it is at rest at 1.017 R0 for
/// the 4 x 20 mm device, and its dL0 / dR0 is 0.354 there, whatever t.
struct BraidLattice {
    int nodes_per_ring = 0;       ///< n
    int num_rings = 0;            ///< N
    double nominal_radius = 0.0;  ///< R0 [m]
    double ring_spacing = 0.0;    ///< dL0 [m]
    double arm_width = 0.0;       ///< dR0, arc between the ends of an arm [m]
    double arm_length = 0.0;      ///< l0, force-free distance between the ends of an arm [m]
    double stagger = 0.5;         ///< of a ring against the one before [node spacings]
    std::array<int, 2> arm_steps{-1, 0};  ///< columns; right-handed, left-handed; within -n to n
    /// Force-free radius of each ring [m], for a device with a flare or a cone; empty: R0.
    std::vector<double> rest_radii = {};
    /// Force-free spacing from each ring to the next [m]; empty: dL0.
    std::vector<double> gap_spacings = {};
    /// Force-free lengths of the arms from each ring to the next, by `arm_steps`, of a twisted
    /// braid
    /// (`axial_twist.hpp`) [m]; empty: l0.
    std::vector<std::array<double, 2>> arm_lengths = {};

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
    /// Force-free radius of a ring [m].
    double rest_radius(int ring) const
    {
        return rest_radii.empty() ? nominal_radius : rest_radii[static_cast<std::size_t>(ring)];
    }
    /// Force-free spacing from a ring to the next [m].
    double gap_spacing(int ring) const
    {
        return gap_spacings.empty() ? ring_spacing : gap_spacings[static_cast<std::size_t>(ring)];
    }
    /// Force-free length of an arm from a ring to the next, along `arm_steps[family]` [m].
    double rest_length(int ring, std::size_t family) const
    {
        return arm_lengths.empty() ? arm_length
                                   : arm_lengths[static_cast<std::size_t>(ring)][family];
    }
    /// Area of the device's surface that an inner node stands for, force-free [m^2]:
    /// dL0 2 pi R0 / n.
    double node_area() const
    {
        return ring_spacing * 2.0 * std::numbers::pi * nominal_radius / nodes_per_ring;
    }
    /// Share of the area of an inner node that a node of a ring stands for. Of the crossings: the
    /// rhombi around a node, out of four: it is the distal corner of one, the proximal of another,
    /// and at the side of two, but for the rings at the ends. Of the paper's lattice: half at the
    /// ends.
    double area_share(int ring) const
    {
        if (stagger == 0.0) return ring == 0 || ring + 1 == num_rings ? 0.5 : 1.0;
        const int distal = ring + 2 < num_rings ? 1 : 0;
        const int proximal = ring >= 2 ? 1 : 0;
        const int sides = ring >= 1 && ring + 1 < num_rings ? 2 : 0;
        return 0.25 * (distal + proximal + sides);
    }
};

/// The lattice of a device. The crossings have N - 1 = round(L0 / dL0) gaps, at least 2.
///
/// With a flare (or a cone, of negative flare f) the force-free radius at a distance x from that
/// end, in nominal length, is
///
///     R0 + f (1 - u)^2 (1 + 2 u),   u = x / flare_length < 1
///
/// and the spacing there is that at which no arm is stretched (`braid_kinematics.hpp`): a flare is
/// set into the braid, whose wires keep their length.
/// @throws ConfigError if the device is not a valid one, or the braid cannot open as far as a flare
///         wants
BraidLattice make_lattice(const FlowDiverter& device, LatticeKind kind = LatticeKind::crossings);

/// Corners of rhombus (ring k, column j) of the crossings, anticlockwise seen from outside: (k, j),
/// (k+1, j-1), (k+2, j-1), (k+1, j). Corners 0-1 and 3-2 lie along right-handed wires, 0-3 and 1-2
/// along left-handed ones. k = 0 ... N-3.
std::array<int, 4> rhombus_corners(const BraidLattice& lattice, int ring, int column);

}  // namespace braidzone
