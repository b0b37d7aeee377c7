#pragma once

#include "core/triangle_mesh.hpp"

#include <string>
#include <utility>
#include <vector>

namespace braidzone {

/// A sound surface from a defective one, by CGAL's Polygon Mesh Processing: merges equal points,
/// drops degenerate and repeated triangles, turns triangles that wind against their neighbours,
/// splits non-manifold edges and points, drops parts of less than a tenth of the largest part's
/// area, removes self-intersections, and turns the normals out of the lumen. For use when the user
/// asks for it only. Holes stay.
///
/// @return the repaired surface and one sentence for each thing changed
/// @throws GeometryError if defects remain
std::pair<TriangleMesh, std::vector<std::string>> repair(const TriangleMesh& mesh);

}  // namespace braidzone
