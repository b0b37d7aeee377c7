#pragma once

#include "core/wall_tree.hpp"
#include "deploy/node_contact.hpp"

namespace braidzone {

/// The vessel's wall as nodes of a wire network meet it: each triangle within range is a piece of
/// its own, so that creases and ridges between triangles are what they are.
/// @param wall  must outlive the obstacle
Obstacle wall_obstacle(const WallTree& wall);

}  // namespace braidzone
