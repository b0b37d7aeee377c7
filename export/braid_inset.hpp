#pragma once

#include "core/triangle_mesh.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"

#include <vector>

namespace braidzone {

/// A braid moved off the wall, so that a layer of some thickness about it lies in the lumen.
///
/// Nodes of a deployment are the middle of a sheet without thickness and lie on the wall where the
/// device does; a layer of real thickness about them would stand out of the vessel. Moved inwards
/// along the braid's normals by half of its thickness it lies on the wall. Where the device is free
/// nothing is moved, but for a transition over a few nodes: a node is moved at least by the mean of
/// its neighbours, so that the braid does not step down where the wall ends.
struct InsetBraid {
    std::vector<Vec3> nodes;     ///< |N| x 3 [m]
    std::vector<Vec3> normals;   ///< of the braid at its nodes, unit, to the wall
    double largest_inset = 0.0;  ///< [m]
};

/// @param distance  of the nodes, of the wires between them and of the rhombi from the wall at
/// least
///                  [m]; kept within 1 % of it, but for walls that narrow faster than the braid
InsetBraid inset_braid(const Deployment& deployment, const WallTree& wall, double distance);

/// The inner side of a layer about an inset braid, normals to the wall: what a second device lies
/// on.
/// @param depth  from the braid to the inner side [m]
TriangleMesh inner_face(const BraidLattice& lattice, const InsetBraid& braid, double depth);

}  // namespace braidzone
