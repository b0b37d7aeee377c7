#pragma once

#include "core/wall_tree.hpp"
#include "deploy/crimped_braid.hpp"
#include "deploy/network_release.hpp"

namespace braidzone {

/// Releases a crimped braid whose nodes stay in the planes of their rings, but move freely there:
/// around the ring where no wall holds them (hoop migration), and with the ring, whose hub is the
/// mean of its nodes.
///
/// Rings are released from the distal end, or all at once. After each release the network comes to
/// rest (`network_relaxation.hpp`): the motion is quasi-static. Nodes that have come to touch the
/// wall are then anchored there, and slide at Coulomb's limit.
///
/// @param arc_lengths  of the rings on the centerline [m]
ReleasedNetwork release_in_planes(const WireNetwork& network, const CrimpedBraid& crimped,
                                  const std::vector<double>& arc_lengths, ReleaseOrder order,
                                  const WallTree& wall, const NetworkRelease& release);

}  // namespace braidzone
