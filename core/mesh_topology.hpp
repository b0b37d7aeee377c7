#pragma once

#include "core/triangle_mesh.hpp"

#include <array>
#include <vector>

namespace braidzone {

/// One side of a triangle.
struct TriangleSide {
    int low = 0;           ///< the edge's point of smaller index
    int high = 0;          ///< the edge's point of larger index
    int triangle = 0;      ///< whose side it is
    bool forward = false;  ///< true if the triangle runs from `low` to `high`
};

/// The sides of all triangles, those of one edge beside each other: sorted by edge, then triangle.
std::vector<TriangleSide> sorted_sides(const TriangleMesh& mesh);

/// Calls `visit(first, last)` with the range of sides of each edge, in order.
template <typename Visit>
void for_each_edge(const std::vector<TriangleSide>& sides, Visit visit)
{
    for (auto first = sides.begin(); first != sides.end();) {
        auto last = first + 1;
        while (last != sides.end() && last->low == first->low && last->high == first->high)
            ++last;
        visit(first, last);
        first = last;
    }
}

/// The parts of a surface that share no point, each as its triangles in order; parts in the order
/// of their first triangle.
std::vector<std::vector<int>> connected_parts(const TriangleMesh& mesh);

/// The rims of an open surface: closed loops of the edges that belong to one triangle only.
///
/// A loop runs against its triangles, so that a cap fanned over it winds as the surface does: seen
/// from outside it is anticlockwise. Loops are in the order of their smallest point, from which
/// each starts.
///
/// @param mesh  manifold and consistently wound; otherwise loops may be missing
std::vector<std::vector<int>> border_loops(const TriangleMesh& mesh);

/// Closes a loop of `border_loops` by a fan of triangles about `centre`, a new point.
void append_fan(TriangleMesh& mesh, const std::vector<int>& loop, const Vec3& centre);

/// The given triangles of a mesh with the points they use, both in their old order.
TriangleMesh submesh(const TriangleMesh& mesh, const std::vector<int>& triangles);

}  // namespace braidzone
