#pragma once

#include "core/vessel.hpp"
#include "porous/voxel_cubes.hpp"
#include "porous/voxel_grid.hpp"

#include <vector>

namespace braidzone {

/// Distance of voxel centres to the vessel's wall [m], negative in the lumen; the flat caps over
/// the openings bound the lumen but are no wall. Held voxel by voxel near the wall and where it was
/// asked for, elsewhere as one number for a cube of voxels.
struct VoxelWallDistance {
    VoxelCubes cubes;
    std::vector<float> of_voxels;  ///< of the held cubes' voxels
    std::vector<float> of_cubes;   ///< of the centre of each cube; the wall does not enter it
};

/// Distance at a voxel: its own in a held cube, that of the cube's centre elsewhere [m].
float distance_at(const VoxelWallDistance& field, int i, int j, int k);

/// Computes the distances.
///
/// Each voxel keeps the nearest triangle known so far. Those within one voxel of the wall are found
/// by scanning the voxels around each triangle, the middle of each cube from a tree of boxes. From
/// these the triangle is handed on from voxel to voxel (Danielsson 1980, doi
/// 10.1016/0146-664X(80)90054-4, with triangles for features); every other one walks on over the
/// wall as long as a triangle that shares a corner is nearer. Distances are exact up to one voxel
/// from the wall. Beyond, a voxel that is about equally far from several parts of the wall may take
/// the wrong one and is then too far by a quarter of the spacing at most.
///
/// The side is that of the nearest face, or of the angle-weighted normal at the nearest edge or
/// corner (Baerentzen and Aanaes 2005, doi 10.1109/TVCG.2005.49), up to one voxel from the wall. It
/// passes from a voxel to its neighbour where their distances show that no wall lies between (their
/// sum exceeds the step); else `WallTree::contains` is asked.
///
/// Time and memory grow with the area of the wall in the grid and with the marked cubes. The result
/// does not depend on the number of threads.
///
/// @param marks  cubes to hold; those that the wall enters are held, too
VoxelWallDistance voxel_wall_distance(const VoxelGrid& grid, const Vessel& vessel, CubeMarks marks);

}  // namespace braidzone
