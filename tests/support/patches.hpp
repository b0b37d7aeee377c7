#pragma once

#include "deploy/deployment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace braidzone::test {

/// Patches of the vessel's surface: pieces of arc length by pieces of the angle about the
/// centerline's frame.
struct PatchGrid {
    double from = 0.0;       ///< arc length on the centerline [m]
    double length = 0.8e-3;  ///< of a patch along the centerline [m]
    int along = 1;
    int around = 12;  ///< 30 degrees each
};

/// Radius about its hub of a ring's polygon of nodes at an angle about the ring's frame, linear in
/// the angle between two nodes [m].
inline double ring_radius(const Deployment& deployment, int ring, double angle)
{
    const CrossSection& hub = deployment.rings[static_cast<std::size_t>(ring)];
    const int n = deployment.lattice.nodes_per_ring;
    const auto polar = [&](int column) {
        const Vec3 offset =
            deployment.nodes[static_cast<std::size_t>(deployment.lattice.node(ring, column))] -
            hub.origin;
        return std::pair(std::atan2(offset.dot(hub.binormal), offset.dot(hub.normal)),
                         std::hypot(offset.dot(hub.binormal), offset.dot(hub.normal)));
    };
    constexpr double turn = 2.0 * std::numbers::pi;
    for (int column = 0; column < n; ++column) {
        const auto [first, first_radius] = polar(column);
        const auto [second, second_radius] = polar((column + 1) % n);
        const double width = std::remainder(second - first, turn);
        const double along = std::remainder(angle - first, turn);
        if (along >= 0.0 && along <= width)
            return first_radius + along / width * (second_radius - first_radius);
    }
    return std::nan("");
}

/// Mean radius about the hubs of the deployed surface on each patch [m], from 8 x 6 points of the
/// surface that is linear between rings and between the nodes of a ring.
inline std::vector<double> patch_means(const Deployment& deployment, const PatchGrid& grid)
{
    constexpr int samples_along = 8, samples_around = 6;
    const std::vector<double>& place = deployment.ring_arc_length;  // decreasing
    std::vector<double> means;
    for (int i = 0; i < grid.along; ++i) {
        for (int j = 0; j < grid.around; ++j) {
            double sum = 0.0;
            for (int a = 0; a < samples_along; ++a) {
                const double s = grid.from + (i + (a + 0.5) / samples_along) * grid.length;
                const auto below =
                    std::lower_bound(place.begin() + 1, place.end() - 1, s, std::greater<double>());
                const int ring = static_cast<int>(below - place.begin()) - 1;
                const double share = (*(below - 1) - s) / (*(below - 1) - *below);
                for (int b = 0; b < samples_around; ++b) {
                    const double angle =
                        2.0 * std::numbers::pi * (j + (b + 0.5) / samples_around) / grid.around;
                    sum += (1.0 - share) * ring_radius(deployment, ring, angle) +
                           share * ring_radius(deployment, ring + 1, angle);
                }
            }
            means.push_back(sum / (samples_along * samples_around));
        }
    }
    return means;
}

}  // namespace braidzone::test
