#pragma once

#include "deploy/crimped_braid.hpp"
#include "deploy/flow_diverter.hpp"

#include <vector>

namespace braidzone {

/// Ring spacing at which the wires of a family touch [m]. With the crossings at the corners of
/// rhombi of diagonals 2 L and 2 dR, the wires of a family are
///
///     p = 2 L dR / sqrt(L^2 + dR^2) = 2 L cos b,   tan b = L / dR
///
/// apart, which is the wire diameter d at
///
///     2 L = d / cos b,   L = 1 / sqrt(4 / d^2 - 1 / dR^2)
///
/// 15.04 um for wires of 30 um, 0.2 mm apart around the ring or more: a braid is compacted until
/// its wires touch side by side, and no further.
///
/// @param wire_diameter  d [m]; > 0
/// @param node_spacing   dR, half the distance of the crossings along a ring [m]; > d / 2
double touching_spacing(double wire_diameter, double node_spacing);

/// The least spacing of a lattice's rings, on the ray of a node, that the mechanics allow [m]:
///
///     1.1 touching_spacing(d, pi R0 / n)
///
/// at the crossings, and as many times that as a coarse lattice's rings are further apart. The
/// tenth is what pores are left: resistance laws hold up to a solidity of 0.95.
double least_ring_spacing(const FlowDiverter& device, const BraidLattice& lattice);

/// Distance between the planes of neighbouring rings that `ring_planes.hpp` is to keep [m]: 1.15
/// times the least spacing, so that rings which do not cross do not jam either, tilted as they are.
double least_plane_gap(const FlowDiverter& device, const BraidLattice& lattice);

/// Where jammed wires stop each node: the furthest distance from the hub along its ray at which it
/// still is `least_spacing` from the planes of both neighbouring rings [m]. With h from the
/// neighbour's hub to the node's, u the normal of the neighbour's plane towards the node, and e
/// the ray,
///
///     stop = (h . u - least_spacing) / (- e . u)     where e . u < 0
///
/// and infinite elsewhere: where the planes of rings lean towards each other, inside of a bend, the
/// nodes stop on a line across the ring, and the device lifts off the wall behind it. Never below
/// the crimped radius; hubs that are nearer than the least spacing do not stop the nodes around
/// them, whose radius would not part them.
std::vector<double> jam_stops(const CrimpedBraid& braid, double least_spacing);

/// The nearer of two stops, with a corner rounded off where they are nearer to each other than
/// `width`, so that stops are continuously differentiable in what they depend on:
///
///     min(a, b) - (width - |a - b|)^2 / (4 width)
///
/// @param width  [m]; > 0
double nearer_stop(double a, double b, double width);

}  // namespace braidzone
