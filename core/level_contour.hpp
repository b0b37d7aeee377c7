#pragma once

#include "core/triangle_mesh.hpp"

#include <functional>

namespace braidzone {

/// The zero level of a function as a closed triangle mesh, by dual contouring of voxels (OpenVDB).
///
/// The points lie within a voxel of the level; their triangles are of very different sizes.
/// Only voxels near the level are evaluated.
///
/// @param level   negative inside; changes by no more than the distance between two points
/// @param bounds  holds the zero level
/// @param voxel   edge of a voxel [m]; > 0
/// @return normals out of the inside
TriangleMesh contour(const std::function<double(const Vec3&)>& level, const Box& bounds,
                     double voxel);

}  // namespace braidzone
