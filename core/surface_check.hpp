#pragma once

#include "core/triangle_mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace braidzone {

/// What is wrong with a surface, element by element. Indices are those of the mesh as read.
struct SurfaceDefects {
    std::vector<int> degenerate_triangles;               ///< no area, or two equal corners
    std::vector<std::array<int, 2>> non_manifold_edges;  ///< point pairs in three triangles or more
    std::vector<int> non_manifold_points;                ///< points where the surface pinches
    std::vector<std::array<int, 2>> inconsistent_edges;  ///< neighbours wind in opposite senses
    std::vector<std::array<int, 2>> intersecting_triangles;  ///< pairs of triangles that cross
    int num_components = 0;                                  ///< connected parts
    bool is_inverted = false;  ///< the normals of a consistent surface point into the lumen
};

/// Examines a surface (Botsch et al. 2010, Polygon Mesh Processing, chapter 8).
///
/// A triangle is degenerate if its area is below 1e-12 of the square of the bounding box's
/// diagonal over the number of triangles. Self-intersection is tested only on a consistent manifold
/// without degenerate triangles, and inversion only if it is in one part besides.
/// @return the defects; all lists empty for a sound surface
SurfaceDefects find_defects(const TriangleMesh& mesh);

/// True if nothing in the list keeps the surface from being used as a vessel wall.
bool is_sound(const SurfaceDefects& defects);

/// True if a surface, its rims closed, encloses a negative volume: its normals point inwards.
/// @param mesh  consistently wound, in one part
bool is_inverted(const TriangleMesh& mesh);

/// One line per kind of defect, with count and the first five elements; empty if sound.
std::string describe(const SurfaceDefects& defects);

}  // namespace braidzone
