#include "deploy/wire_jam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace braidzone {

namespace {

/// Least spacing over that at which wires touch, see the header.
constexpr double pore_margin = 1.1;

constexpr double tilt_margin = 1.15;

constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace

double touching_spacing(double wire_diameter, double node_spacing)
{
    return 1.0 /
           std::sqrt(4.0 / (wire_diameter * wire_diameter) - 1.0 / (node_spacing * node_spacing));
}

double least_ring_spacing(const FlowDiverter& device, const BraidLattice& lattice)
{
    const double node_spacing = 2.0 * std::numbers::pi * device.nominal_radius() / device.num_wires;
    const double coarseness = lattice.ring_spacing / (device.braid_ratio * node_spacing);
    return pore_margin * coarseness * touching_spacing(device.wire_diameter, node_spacing);
}

double least_plane_gap(const FlowDiverter& device, const BraidLattice& lattice)
{
    return tilt_margin * least_ring_spacing(device, lattice);
}

std::vector<double> jam_stops(const CrimpedBraid& braid, double least_spacing)
{
    std::vector<double> stops(braid.rays.size(), unlimited);
    const auto stop_at = [&](int ring, const CrossSection& neighbour, const Vec3& towards) {
        const Vec3& hub = braid.rings[static_cast<std::size_t>(ring)].origin;
        const double room = (hub - neighbour.origin).dot(towards) - least_spacing;
        if (!(room > 0.0)) return;
        for (int column = 0; column < braid.lattice.nodes_per_ring; ++column) {
            const auto node = static_cast<std::size_t>(braid.lattice.node(ring, column));
            const double approach = -braid.rays[node].dot(towards);
            if (approach > 0.0)
                stops[node] = std::min(stops[node], std::max(braid.radius, room / approach));
        }
    };
    for (int ring = 0; ring < braid.lattice.num_rings; ++ring) {
        if (ring > 0) {
            const CrossSection& distal = braid.rings[static_cast<std::size_t>(ring - 1)];
            stop_at(ring, distal, -distal.tangent);
        }
        if (ring + 1 < braid.lattice.num_rings) {
            const CrossSection& proximal = braid.rings[static_cast<std::size_t>(ring + 1)];
            stop_at(ring, proximal, proximal.tangent);
        }
    }
    return stops;
}

double nearer_stop(double a, double b, double width)
{
    const double nearer = std::min(a, b);
    const double overlap = width - std::abs(a - b);
    return overlap > 0.0 ? nearer - overlap * overlap / (4.0 * width) : nearer;
}

}  // namespace braidzone
