#pragma once

#include "core/vector.hpp"

#include <limits>
#include <vector>

namespace braidzone {

/// Where two wires come nearest to each other.
struct WireGap {
    double distance = std::numeric_limits<double>::infinity();  ///< of their middle lines [m]
    Vec3 place = Vec3::Zero();                                  ///< on one of them [m]
    /// Pairs of straight pieces of different wires that are nearer than the distance asked for.
    std::size_t num_closer = 0;
};

/// The smallest distance between different polylines, from all pairs of pieces whose boxes are
/// within reach (CGAL's box intersection and squared distance of segments).
/// @param reach   distances beyond are not looked for; infinite if there is none [m]
/// @param closer  distance that `num_closer` counts by; <= `reach` [m]
WireGap smallest_gap(const std::vector<std::vector<Vec3>>& lines, double reach, double closer);

}  // namespace braidzone
