#pragma once

#include "deploy/deployment.hpp"
#include "deploy/neck.hpp"
#include "export/lattice_nodes.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace braidzone {

/// A place where flow passes through the device, and the way out of the parent vessel there.
struct NeckProbe {
    Vec3 centre = Vec3::Zero();     ///< on the device [m]
    Vec3 outwards = Vec3::UnitX();  ///< unit
};

/// The node in the middle of each opening behind a device, and the way to it from its ring's hub;
/// none for an opening without nodes.
std::vector<NeckProbe> neck_probes(const Deployment& deployment,
                                   const std::vector<WallOpening>& openings);

/// Whether the device's nodes part what lies behind a neck from the parent vessel.
enum class NeckSeal {
    sealed,
    leaks,   ///< fluid nodes without resistance lead from the inlet behind the device
    absent,  ///< no node without resistance lies behind it
};

std::string_view name_of(NeckSeal seal);

struct LatticeSeal {
    std::vector<NeckSeal> necks;  ///< of each probe
    /// Fluid nodes without resistance that the flood does not reach: sacs and branches behind the
    /// device.
    std::int64_t num_behind = 0;
};

/// Floods the lumen from the inlet through fluid nodes without resistance, from node to neighbour
/// along the axes. Behind a neck is the first such node on the ray from its centre outwards.
LatticeSeal lattice_seal(const LatticeNodes& nodes, const std::vector<NeckProbe>& probes);

}  // namespace braidzone
