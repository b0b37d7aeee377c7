#pragma once

#include "porous/rhombus.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// A quantity on which a resistance law's validity depends, with the range that its source covers.
struct RangeCheck {
    const char* quantity = "";  ///< in words, e.g. "solidity (wire diameter over spacing)"
    double value = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
};

/// Velocity at which Reynolds numbers are held against a law's range [m/s]: flow through the neck
/// of a treated aneurysm is 0.005 to 0.1 m/s.
inline constexpr double neck_velocity = 0.05;

/// Solidity above which the wires of a family touch somewhere, so that there is no pore to flow
/// through and no law holds [-].
inline constexpr double jammed_solidity = 0.95;

/// True if a family's solidity is above `jammed_solidity`.
bool is_jammed(const Rhombus& rhombus);

/// The cell nearest to a jammed one that is not: its crossing angle is opened until the denser
/// family has the solidity 0.95, its edges keep their lengths (an edge shorter than that spacing
/// gets its length). Any other cell is returned as it is. The braid angle is kept.
Rhombus opened_to_limit(const Rhombus& rhombus);

/// Refuses a jammed cell, for laws that are called by themselves.
/// @param law  whose loss was asked for
/// @throws InputError if a family's solidity is above 0.95
void require_pores(const Rhombus& rhombus, const char* law);

/// Sentences about cells outside a law's range, one for each quantity and side.
/// @param law     its name
/// @param checks  of each cell, the same quantities in the same order
std::vector<std::string> range_warnings(const std::string& law,
                                        const std::vector<std::vector<RangeCheck>>& checks);

}  // namespace braidzone
