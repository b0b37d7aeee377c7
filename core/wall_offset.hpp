#pragma once

#include "core/triangle_mesh.hpp"

namespace braidzone {

/// A surface moved outwards along its normals: what another threshold of the segmentation would
/// have made of the vessel.
///
///     p' = p + offset n,   n: mean of the normals of the triangles at p, weighted by their angles
///
/// (Thuermer and Wuethrich 1998, doi 10.1080/10867651.1998.10487487). Meant for offsets that are
/// small against the edges; nothing keeps a wall from crossing itself at larger ones.
///
/// @param offset  [m]; negative: inwards
/// @throws InputError if the offset is not finite
TriangleMesh with_wall_offset(const TriangleMesh& mesh, double offset);

}  // namespace braidzone
