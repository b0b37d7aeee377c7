#pragma once

#include "deploy/braid_lattice.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// How the wires of a braid interlace: each passes over `over` crossings, then under as many.
///
/// A braiding machine leads its carriers on two tracks that wind about the same circle of horn
/// gears, so that a wire lies outside or inside according to where it is on that circle. With all
/// places on the machine taken, that makes two over and two under, the regular braid; with every
/// second one, one and one, the diamond braid (Brunnschweiler 1953, J. Text. Inst. 44, P666). The
/// regular one, 48 wires from a machine of 48 carriers, is the default: no maker of a flow diverter
/// was found to state its pattern.
struct BraidPattern {
    int over = 2;  ///< 1, 2 or 3
};

/// The patterns' names, "1-over-1" to "3-over-3"; the name at place i has `over` = i + 1.
std::vector<std::string> braid_pattern_names();

/// True if a pattern closes around a braid: the n crossings of a ring make whole repeats.
bool closes_around(const BraidPattern& pattern, int nodes_per_ring);

/// Whether the right-handed wire lies outside at a crossing, the left-handed one inside: for half
/// of the places around the braid, in bands of `over` half node spacings.
/// @param pattern  that closes around the lattice
bool right_handed_is_outside(const BraidPattern& pattern, const BraidLattice& lattice, int ring,
                             int column);

}  // namespace braidzone
