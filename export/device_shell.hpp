#pragma once

#include "core/triangle_mesh.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"

namespace braidzone {

/// The surface of a deployed device as a closed thin solid, for programs that fill solids with
/// voxels: two triangles a rhombus on each side, at half the thickness along the nodes' normals,
/// and a strip along both rims. Normals point out of the solid.
///
/// It is the device's skin without its pores. Where the device lies on the wall, the solid is moved
/// inwards (`inset_braid`), so that it lies beside the wall and does not cut it.
///
/// Where the braid is bent more sharply than its thickness, triangles may cross: `find_defects`
/// tells.
///
/// @param thickness  [m]; > 0
/// @param wall_gap   between the solid and the wall [m]; >= 0
TriangleMesh make_device_shell(const Deployment& deployment, double thickness, const WallTree& wall,
                               double wall_gap);

}  // namespace braidzone
