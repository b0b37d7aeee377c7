#include "deploy/wire_stretch.hpp"

#include <algorithm>
#include <limits>

namespace braidzone {

WireStretch wire_stretch(const Deployment& deployment)
{
    const BraidLattice& lattice = deployment.lattice;
    const auto place = [&](int ring, int column) -> const Vec3& {
        return deployment.nodes[static_cast<std::size_t>(lattice.node(ring, column))];
    };
    double length = 0.0, lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
    int num_arms = 0;
    for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            for (const int step : lattice.arm_steps) {
                const double arm = (place(ring + 1, column + step) - place(ring, column)).norm();
                length += arm;
                lowest = std::min(lowest, arm);
                highest = std::max(highest, arm);
                ++num_arms;
            }
        }
    }
    const double rest = lattice.arm_length;
    return {length / (num_arms * rest) - 1.0, lowest / rest - 1.0, highest / rest - 1.0};
}

}  // namespace braidzone
