#pragma once

#include "core/vessel.hpp"
#include "porous/voxel_grid.hpp"

#include <vector>

namespace braidzone {

/// Distance of each voxel centre to the vessel's wall [m], negative in the lumen; the flat caps
/// over the openings bound the lumen but are no wall.
///
/// Each voxel keeps the nearest triangle known so far. Those within one voxel of the wall are found
/// by scanning the voxels around each triangle, those on every fourth voxel from a tree of boxes.
/// From these the triangle is handed on to the voxels between (Danielsson 1980, doi
/// 10.1016/0146-664X(80)90054-4, with triangles for features), and each walks on over the wall as
/// long as a triangle that shares a corner is nearer. Distances are exact up to one voxel from the
/// wall. Beyond, a voxel that is about equally far from several parts of the wall may take the
/// wrong one and is then too far by a fraction of the spacing.
///
/// The sign passes from a voxel to its neighbour where their distances show that no wall lies
/// between (their sum exceeds the step), elsewhere `WallTree::contains` is asked.
///
/// The result does not depend on the number of threads.
std::vector<float> voxel_wall_distance(const VoxelGrid& grid, const Vessel& vessel);

}  // namespace braidzone
