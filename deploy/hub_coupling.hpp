#pragma once

#include "deploy/ring_band_matrix.hpp"
#include "deploy/wire_network.hpp"

namespace braidzone {

/// Adds the second derivatives that couple the nodes of a ring through its hub, which
/// `add_network_hessian` leaves out: both together are positive semidefinite and let a ring move as
/// a whole at no cost to its radial springs. Needed where rings travel, as when a device bends
/// between supports; a device in a vessel is held all around and comes to rest without.
///
/// For the radial springs with the derivative A_c of node c, and S their sum over a ring of n
/// nodes:
///
///     d2E / dx_c dx_d = - (A_c + A_d) / n + S / n^2
///
/// and for the bending of the wires, with g = 2 (1 - cos(pi / n)), between two nodes of a ring and
/// between nodes of neighbouring rings:
///
///     2 k_b g (4 - g) / n          and        - 2 k_b g / n
void add_hub_coupling(const WireNetwork& network, const NetworkShape& shape, RingRange active,
                      RingBandMatrix& hessian);

}  // namespace braidzone
