#pragma once

#include "core/wall_tree.hpp"

namespace braidzone {

/// A point of a braid's surface, moved into the lumen along the braid's normal until it is at least
/// a distance from the wall.
///
/// Nodes of a deployment are the middle of a sheet without thickness and lie on the wall where the
/// device does. A layer of real thickness about them would stand out of the vessel; moved inwards
/// by half of its own thickness it lies on the wall. Where the device is free nothing is moved.
///
/// @param point     within `distance` of the lumen [m]
/// @param normal    unit, of the braid, to the wall
/// @param distance  [m]
Vec3 off_the_wall(const Vec3& point, const Vec3& normal, const WallTree& wall, double distance);

}  // namespace braidzone
