#include "discrepancy/contact_force.hpp"

#include <algorithm>

namespace braidzone {

double contact_force(const Deployment& deployment, double from, double to)
{
    const std::vector<double>& places = deployment.ring_arc_length;  // decreasing
    double force = 0.0;
    for (std::size_t ring = 0; ring < places.size(); ++ring) {
        const double upper = ring == 0 ? places[ring] : 0.5 * (places[ring - 1] + places[ring]);
        const double lower =
            ring + 1 == places.size() ? places[ring] : 0.5 * (places[ring] + places[ring + 1]);
        const double inside = std::min(upper, to) - std::max(lower, from);
        const double share = std::clamp(inside / (upper - lower), 0.0, 1.0);
        if (share == 0.0) continue;
        const int row = static_cast<int>(ring);
        for (int column = 0; column < deployment.lattice.nodes_per_ring; ++column) {
            force +=
                share *
                deployment
                    .contact_force[static_cast<std::size_t>(deployment.lattice.node(row, column))];
        }
    }
    return force;
}

}  // namespace braidzone
