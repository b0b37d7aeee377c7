#pragma once

#include "core/given_centerline.hpp"

#include <vector>

namespace braidzone {

/// The line that is meant out of several (`given_centerline`).
struct ChosenLine {
    Polyline line;       ///< as it is given, in the direction that is meant
    int num_others = 0;  ///< lines that lead elsewhere
};

/// @throws ConfigError and InputError as `given_centerline`
ChosenLine chosen_line(const std::vector<Polyline>& lines, const Vessel& vessel,
                       const WallTree& wall, const LineChoice& choice);

}  // namespace braidzone
