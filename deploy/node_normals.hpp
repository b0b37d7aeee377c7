#pragma once

#include "core/vector.hpp"
#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

/// Unit normals of a braid's surface at its nodes, from the axis to the wall: the mean of the
/// vector areas of the rhombi around each node.
/// @param lattice  of the crossings
/// @param nodes    |N| x 3 [m]
std::vector<Vec3> node_normals(const BraidLattice& lattice, const std::vector<Vec3>& nodes);

/// The rhombi of a lattice of crossings as triangles of its nodes, normals to the wall: rhombus i,
/// counted as in `BraidSurface`, is triangles 2 i and 2 i + 1. Cut between the two nodes of one
/// ring, the shorter diagonal of a braid that lies well.
std::vector<std::array<int, 3>> rhombus_triangles(const BraidLattice& lattice);

}  // namespace braidzone
