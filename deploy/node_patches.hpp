#pragma once

#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

/// For each flagged node of a lattice, the lowest node of its connected patch; -1 elsewhere. Nodes
/// of one rhombus are connected.
/// @param flagged  one for each node
std::vector<int> connected_patches(const BraidLattice& lattice, const std::vector<char>& flagged);

}  // namespace braidzone
