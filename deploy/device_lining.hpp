#pragma once

#include "core/triangle_mesh.hpp"
#include "deploy/deployment.hpp"

namespace braidzone {

/// The inner surface of a deployed device, on which a second device inside it comes to rest:
/// each rhombus as two triangles, offset towards the axis along the normals by the thickness of a
/// crossing, two wires. Normals point to the wall.
///
/// The device is taken as rigid and as a closed skin: the second one neither opens it further nor
/// sinks into its pores. A pore is a few tenths of a millimetre wide, as are those of the second
/// one, whose wires bridge it.
///
/// Triangles 2 i and 2 i + 1 are those of rhombus i.
TriangleMesh inner_surface(const Deployment& deployment, double wire_diameter);

/// Gives a device that was deployed within another one its distances from the vessel's wall: to
/// the lining, plus that of the first device there, which is 0 where the first device lies on the
/// wall. So the second one counts as free of the wall where both are, over the neck.
///
/// @param second       deployed in `lined_wall`
/// @param first        the device whose inner surface the lining is
/// @param lined_wall   the vessel's wall with that lining
/// @param num_wall_triangles  of the vessel's wall: triangles from this number on are the lining's
void measure_wall_distance_through(Deployment& second, const Deployment& first,
                                   const WallTree& lined_wall, int num_wall_triangles);

}  // namespace braidzone
