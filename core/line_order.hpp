#pragma once

#include "core/centerline.hpp"

#include <vector>

namespace braidzone {

/// A line whose points follow each other along the vessel.
struct OrderedLine {
    Polyline line;
    int num_misplaced = 0;  ///< points that did not follow their neighbour before
};

/// Puts the points of a line into the order in which they lie along the vessel, where a file has
/// them in another one.
///
/// A line whose segments turn by less than a right angle from one to the next, none longer than
/// three times the median, is in order and stays. Otherwise the points' Euclidean minimum spanning
/// tree (Prim 1957, doi 10.1002/j.1538-7305.1957.tb01515.x) decides: where it is a single chain,
/// that is the order, and it runs in the direction in which most of the given segments do. Where it
/// is not, a line without a jump stays as it is: a segment that is not in the tree, longer than
/// three times the tree's median, and turns back.
///
/// Points that coincide with the one before are dropped when the order changes. Takes quadratic
/// time in the points of lines that are not plainly in order.
///
/// @param line  two points or more, finite [m]
/// @throws GeometryError if the line has a jump and its points form no single chain, with the
///         place of the jump
OrderedLine in_evident_order(const Polyline& line);

}  // namespace braidzone
