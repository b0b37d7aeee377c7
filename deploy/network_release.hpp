#pragma once

#include "core/centerline.hpp"
#include "deploy/deploy_options.hpp"
#include "deploy/wire_network.hpp"

#include <functional>
#include <vector>

namespace braidzone {

/// What the releases of a wire network have in common.
struct NetworkRelease {
    double friction = infinite_friction;  ///< mu between wire and wall [-]
    double contact_offset = 0.0;          ///< distance from the wall at which contact begins [m]
    double contact_stiffness = 0.0;       ///< of the wall's contact with a node [N/m]
    double force_tolerance = 0.0;         ///< of the state of rest [N]
    int most_iterations = 0;              ///< after the last release, before giving up
    /// Called after each release and in the end, with the iterations so far, the rings released,
    /// the shape and the largest force on a node [N].
    std::function<void(int iterations, int num_released, const NetworkShape& shape,
                       double residual)>
        report;
};

/// A wire network at rest in the vessel.
struct ReleasedNetwork {
    std::vector<Vec3> nodes;              ///< |N| x 3 [m]
    std::vector<CrossSection> rings;      ///< the vessel's cross-section at each ring
    std::vector<double> ring_arc_length;  ///< of each ring on the centerline, ring 0 first [m]
    std::vector<double> contact_force;    ///< of each node on the wall [N]
    double residual = 0.0;                ///< largest force on a node [N]
    int iterations = 0;
    double arm_strain = 0.0;  ///< largest change of length of an arm [-]
};

/// Between releases forces need not be as small as in the end: over the final tolerance.
constexpr double loose_tolerance_ratio = 1000.0;
constexpr int most_iterations_per_ring = 40;

/// Step of a node in an iteration over the nominal radius: arms turn by less than a fifth.
constexpr double largest_step_ratio = 0.05;

/// Stiffness, over that of the radial springs, that keeps the solution unique where nothing else
/// does, at next to no cost in iterations; between releases, and in the end.
constexpr double proximal_ratio = 0.02;
constexpr double final_proximal_ratio = 4e-4;

}  // namespace braidzone
