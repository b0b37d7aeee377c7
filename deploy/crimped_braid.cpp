#include "deploy/crimped_braid.hpp"

#include <cassert>
#include <cmath>

namespace braidzone {

CrimpedBraid crimp(const BraidLattice& lattice, const std::vector<CrossSection>& rings,
                   double radius, const std::vector<double>& turns)
{
    assert(static_cast<int>(rings.size()) == lattice.num_rings);
    assert(turns.empty() || turns.size() == rings.size());
    CrimpedBraid braid;
    braid.lattice = lattice;
    braid.rings = rings;
    braid.radius = radius;
    braid.rays.reserve(static_cast<std::size_t>(lattice.num_nodes()));
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const CrossSection& section = rings[static_cast<std::size_t>(ring)];
        const double turn = turns.empty() ? 0.0 : turns[static_cast<std::size_t>(ring)];
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const double angle = lattice.angle(ring, column) + turn;
            braid.rays.push_back(std::cos(angle) * section.normal +
                                 std::sin(angle) * section.binormal);
        }
    }
    return braid;
}

Vec3 on_ray(const CrimpedBraid& braid, int node, double distance)
{
    const std::size_t ring = static_cast<std::size_t>(node / braid.lattice.nodes_per_ring);
    return braid.rings[ring].origin + distance * braid.rays[static_cast<std::size_t>(node)];
}

}  // namespace braidzone
