#include "deploy/hub_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

using Eigen::Matrix3d;

/// The second derivative A_c of each node's radial spring by its place relative to the hub.
std::vector<Matrix3d> radial_derivatives(const WireNetwork& network, const NetworkShape& shape,
                                         int ring)
{
    const int n = network.lattice.nodes_per_ring;
    const auto first = shape.nodes.begin() + ring * n;
    Vec3 hub = Vec3::Zero();
    for (auto node = first; node != first + n; ++node)
        hub += *node / n;
    const double share = network.lattice.area_share(ring);
    std::vector<Matrix3d> derivatives;
    for (auto node = first; node != first + n; ++node) {
        const Vec3 outward = *node - hub;
        const double stiffness =
            share * std::max(0.0, radial_stiffness_at(network.radial, outward.norm()));
        derivatives.emplace_back(stiffness / outward.squaredNorm() * outward * outward.transpose());
    }
    return derivatives;
}

}  // namespace

void add_hub_coupling(const WireNetwork& network, const NetworkShape& shape, RingRange active,
                      RingBandMatrix& hessian)
{
    const int n = network.lattice.nodes_per_ring;
    const double natural = 2.0 * (1.0 - std::cos(std::numbers::pi / n));
    const double of_hub = 2.0 * network.bending_stiffness * natural / n;
    for (int ring = active.first; ring < active.end; ++ring) {
        const int begin = (ring - active.first) * n;
        const auto derivatives = radial_derivatives(network, shape, ring);
        Matrix3d own = Matrix3d::Zero();
        for (const Matrix3d& derivative : derivatives)
            own += derivative / (n * n);
        const bool bends = ring > 0 && ring + 1 < shape.num_rings;
        if (bends) own += of_hub * (4.0 - natural) * Matrix3d::Identity();
        for (int c = 0; c < n; ++c) {
            for (int d = c; d < n; ++d) {
                const Matrix3d both = derivatives[static_cast<std::size_t>(c)] +
                                      derivatives[static_cast<std::size_t>(d)];
                hessian.add(begin + c, begin + d, own - both / n);
            }
        }
        if (!bends) continue;
        for (int neighbour : {ring - 1, ring + 1}) {
            if (neighbour < active.first || neighbour >= active.end) continue;
            const int other = (neighbour - active.first) * n;
            for (int c = 0; c < n; ++c) {
                for (int d = 0; d < n; ++d)
                    hessian.add(begin + c, other + d, -of_hub * Matrix3d::Identity());
            }
        }
    }
}

}  // namespace braidzone
