#pragma once

#include "core/triangle_mesh.hpp"

#include <vector>

namespace braidzone {

/// A surface without near-coincident corners.
struct MergedPoints {
    TriangleMesh mesh;
    int num_merged = 0;     ///< points that were replaced by another one
    std::vector<int> kept;  ///< the old number of each triangle
};

/// Makes corners one that coincide but for rounding, as single-precision files leave them where
/// triangles meet: points nearer to each other than 1e-4 of the mean edge at either of them, if one
/// of the two lies on a rim or is a corner of a triangle whose height is below 1e-4 of its longest
/// side. Triangles that keep fewer than three different corners are dropped; a crack closes.
/// Of points that become one the first stays where it is.
MergedPoints merged_near_points(const TriangleMesh& mesh);

}  // namespace braidzone
