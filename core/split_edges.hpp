#pragma once

#include "core/triangle_mesh.hpp"

#include <vector>

namespace braidzone {

/// A surface whose rims have no corner on an edge.
struct SplitEdges {
    TriangleMesh mesh;
    int num_corners = 0;    ///< at which edges were split
    std::vector<int> from;  ///< the old number of each triangle
};

/// Splits edges on a rim at the corners of other triangles that lie on them, nearer than 1e-4 of
/// the edge and farther than that from its ends: a finer triangle beside a coarser one leaves a
/// slit without width there (a T-junction). The triangle becomes a fan from its third corner; all
/// points stay where they are. A rim that is a loop of edges has no corner on another edge and
/// stays as it is.
SplitEdges with_split_edges(const TriangleMesh& mesh);

}  // namespace braidzone
