#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"
#include "deploy/network_release.hpp"

namespace braidzone {

/// Where a wire network leaves its catheter.
struct AxialLanding {
    double distal = 0.0;           ///< arc length of the distal end on the centerline [m]
    double catheter_radius = 0.0;  ///< [m]
};

/// Releases a network from its catheter, from the distal end, one ring after the other.
///
/// The rings in the catheter are crimped to its radius at the spacing that is force-free there, and
/// follow the centerline; they slide in it freely. So the catheter retreats with the device: what
/// the opening rings lose in length they draw from it, and no force along the axis remains but that
/// of friction. Only the next few rings are laid out at a time. The delivery wire holds the mean of
/// the distal ring at its place until the last ring is released, and afterwards if nothing else
/// does, the wall being frictionless.
///
/// After each release the network comes to rest (`network_relaxation.hpp`): the motion is
/// quasi-static. Nodes that have come to touch the wall are then anchored there, and slide at
/// Coulomb's limit.
///
/// @throws GeometryError if the catheter does not fit into the lumen upstream of the distal end, or
///         the released device reaches beyond the centerline's proximal end
ReleasedNetwork release_along_axis(const WireNetwork& network, const Centerline& centerline,
                                   const WallTree& wall, const AxialLanding& landing,
                                   const NetworkRelease& release);

}  // namespace braidzone
