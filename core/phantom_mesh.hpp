#pragma once

#include "core/phantom_shape.hpp"

namespace braidzone {

/// The wall of a phantom: nearly equilateral triangles, every point on the zero level, open and
/// flat at the ends, whose rims are circles.
///
/// The level's contour is cut off beyond the ends, and then remeshed in rounds: edges are split,
/// collapsed and flipped towards the wanted length and points moved along the surface (Botsch and
/// Kobbelt 2004, doi 10.1145/1057432.1057457; CGAL), then moved onto the level by Newton's method.
/// In one of some hundred vessels a fold comes of it, in which triangles cross; then it begins anew
/// from the contour on another grid.
///
/// @param edge_length  wanted [m]
/// @throws ConfigError if the parts do not make one vessel, or one that touches itself;
///         GeometryError if triangles cross on every grid
TriangleMesh mesh_wall(const PhantomShape& shape, double edge_length);

}  // namespace braidzone
