#pragma once

#include "core/vector.hpp"

#include <array>
#include <vector>

namespace braidzone {

/// A triangulated surface: points [m] and, for each triangle, three point indices.
///
/// Seen from outside the lumen the corners run anticlockwise, so that normals point outwards.
struct TriangleMesh {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;
};

/// Axis-aligned bounds [m].
struct Box {
    Vec3 lower = Vec3::Zero();
    Vec3 upper = Vec3::Zero();
};

/// Vector area of one triangle: half the cross product of its edges, along the outer normal [m^2].
Vec3 area_vector(const TriangleMesh& mesh, int triangle);

/// Sum of the triangles' areas [m^2].
double surface_area(const TriangleMesh& mesh);

/// Volume that a closed surface encloses [m^3], by the divergence theorem: positive if the normals
/// point outwards. Meaningless for an open surface.
double enclosed_volume(const TriangleMesh& mesh);

/// Smallest axis-aligned box that holds every point.
/// @throws InputError if the mesh has no points
Box bounding_box(const TriangleMesh& mesh);

}  // namespace braidzone
