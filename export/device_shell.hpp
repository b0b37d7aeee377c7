#pragma once

#include "core/triangle_mesh.hpp"
#include "export/braid_inset.hpp"

namespace braidzone {

/// The surface of a deployed device as a closed thin solid, for programs that fill solids with
/// voxels: two triangles a rhombus on each side, at half the thickness along the nodes' normals,
/// and a strip along both rims. Normals point out of the solid.
///
/// It is the device's skin without its pores. Where the braid is bent more sharply than its
/// thickness, triangles may cross: `find_defects` tells.
///
/// @param braid      the deployed braid, from the wall by half the thickness at least
/// @param thickness  [m]; > 0
TriangleMesh make_device_shell(const BraidLattice& lattice, const InsetBraid& braid,
                               double thickness);

}  // namespace braidzone
