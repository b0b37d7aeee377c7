#pragma once

#include "core/centerline.hpp"
#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

/// A braid in its catheter: each ring a circle around its hub, in its own plane, the nodes at their
/// lattice angles. The half line from the hub through a node is the node's ray.
struct CrimpedBraid {
    BraidLattice lattice;
    std::vector<CrossSection> rings;  ///< the planes of the rings; their origins are the hubs
    std::vector<Vec3> rays;           ///< |N| unit vectors, one for each node
    double radius = 0.0;              ///< of the crimped rings: that of the catheter [m]
};

/// Lays a braid along the cross-sections of its rings.
/// @param rings   one for each ring of the lattice, distal first
/// @param radius  of the catheter [m]; > 0
/// @param turns   of each ring about its tangent, on top of the lattice's angles [rad]; none: 0
CrimpedBraid crimp(const BraidLattice& lattice, const std::vector<CrossSection>& rings,
                   double radius, const std::vector<double>& turns = {});

/// Place of a node at a distance from its hub along its ray [m].
Vec3 on_ray(const CrimpedBraid& braid, int node, double distance);

}  // namespace braidzone
