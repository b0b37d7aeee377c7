#include "deploy/incomplete_opening.hpp"

#include "core/error.hpp"
#include "core/smooth_step.hpp"
#include "deploy/braid_kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

constexpr double largest_shrink = 0.8;

/// Share by which a ring is narrower than without, on average around it.
double shrink_at(const IncompleteOpening& opening, const std::vector<double>& arc_lengths,
                 std::size_t ring)
{
    const double from_end = opening.end == DeviceEnd::distal
                                ? arc_lengths.front() - arc_lengths[ring]
                                : arc_lengths[ring] - arc_lengths.back();
    return opening.shrink * smooth_step(1.0 - from_end / opening.length);
}

}  // namespace

void validate(const std::vector<IncompleteOpening>& openings)
{
    for (const IncompleteOpening& opening : openings) {
        if (!(opening.length > 0.0 && std::isfinite(opening.length))) {
            throw ConfigError(
                fmt::format("incomplete_opening: length = {:.6g} mm; it must be positive",
                            1e3 * opening.length));
        }
        if (!(opening.shrink >= 0.0 && opening.shrink <= largest_shrink)) {
            throw ConfigError(
                fmt::format("incomplete_opening: shrink = {:.6g}; allowed are 0 (fully open) to {}",
                            opening.shrink, largest_shrink));
        }
        if (!(opening.lean >= 0.0 && opening.lean <= 1.0)) {
            throw ConfigError(fmt::format(
                "incomplete_opening: lean = {:.6g}; allowed are 0 (about the axis) to 1 (one side "
                "on the wall)",
                opening.lean));
        }
        if (!std::isfinite(opening.lean_angle))
            throw ConfigError("incomplete_opening: lean_angle must be a finite angle");
        const auto at_same_end = [&](const IncompleteOpening& other) {
            return other.end == opening.end;
        };
        if (std::count_if(openings.begin(), openings.end(), at_same_end) > 1) {
            throw ConfigError(
                fmt::format("incomplete_opening: the {} end is given twice; keep one of them",
                            opening.end == DeviceEnd::distal ? "distal" : "proximal"));
        }
    }
}

std::vector<double> narrowed_stops(const std::vector<IncompleteOpening>& openings,
                                   const std::vector<double>& stops, const BraidLattice& lattice,
                                   const std::vector<double>& arc_lengths, double braid_ratio,
                                   double smallest)
{
    std::vector<double> narrowed = stops;
    const double widest = radius_ratio(braid_ratio, 0.0) * lattice.nominal_radius;
    for (const IncompleteOpening& opening : openings) {
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            const double shrink = shrink_at(opening, arc_lengths, static_cast<std::size_t>(ring));
            if (!(shrink > 0.0)) continue;
            for (int column = 0; column < lattice.nodes_per_ring; ++column) {
                const double off = lattice.angle(ring, column) - opening.lean_angle;
                const double here = shrink * (1.0 - opening.lean * std::cos(off));
                double& stop = narrowed[static_cast<std::size_t>(lattice.node(ring, column))];
                stop = std::max(smallest, (1.0 - here) * std::min(stop, widest));
            }
        }
    }
    return narrowed;
}

}  // namespace braidzone
