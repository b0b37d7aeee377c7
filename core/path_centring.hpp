#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

/// Moves a path to the middle of the vessel that it runs through, without its ends.
///
/// In each cross-section rays find the wall, a circle is fitted to it, and the path moves to the
/// circle's centre; then the path is smoothed, and so on until it rests. The fit (iteratively
/// reweighted least squares, Tukey's weights) leaves out wall that lies farther away than the
/// circle's: the part of a cross-section that opens into a sac or a branch. What is left of the
/// parent's wall there, half of it say, still has the parent's centre.
///
/// @param path  in the lumen, from grid points say [m]
/// @return smooth path with the distance to the wall as radii
Polyline centred_path(const std::vector<Vec3>& path, const WallTree& wall);

}  // namespace braidzone
