#pragma once

#include <string>
#include <vector>

namespace braidzone {

/// A mark on an axis.
struct Tick {
    double value = 0.0;
    std::string label;
};

/// Marks at multiples of 1, 2 or 5 times a power of ten within a range: as many as fit into
/// `most_ticks`, labelled with the digits that tell them apart.
/// @param lower, upper  ends of the axis; lower < upper
/// @param most_ticks    at least 2
std::vector<Tick> axis_ticks(double lower, double upper, int most_ticks);

}  // namespace braidzone
