#pragma once

#include "core/centerline.hpp"
#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

/// A braid in its catheter, along the centerline of the vessel.
///
/// Ring k lies at `ring_arc_length[k]`, in the plane perpendicular to the centerline there, and its
/// nodes at their lattice angles around the ring's hub, the point of the centerline. The half line
/// from the hub through a node is the node's ray.
struct CrimpedBraid {
    BraidLattice lattice;
    std::vector<double> ring_arc_length;  ///< [m], distal ring first
    std::vector<CrossSection> rings;      ///< the planes of the rings; their origins are the hubs
    std::vector<Vec3> rays;               ///< |N| unit vectors, one for each node
    double radius = 0.0;                  ///< of the crimped rings: that of the catheter [m]
};

/// Lays a braid along a centerline.
/// @param ring_arc_length  where each ring lies [m], within the centerline
/// @param radius           of the catheter [m]; > 0
/// @throws InputError if a ring lies off the centerline
CrimpedBraid crimp(const BraidLattice& lattice, const Centerline& centerline,
                   const std::vector<double>& ring_arc_length, double radius);

/// Place of a node at a distance from its hub along its ray [m].
Vec3 on_ray(const CrimpedBraid& braid, int node, double distance);

}  // namespace braidzone
