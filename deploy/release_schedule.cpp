#include "deploy/release_schedule.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace braidzone {

namespace {

constexpr double smallest_spacing = 0.05;
constexpr double largest_spacing = 2.0;

std::vector<PushPull> sorted_from_distal(const std::vector<PushPull>& windows)
{
    std::vector<PushPull> sorted = windows;
    std::sort(sorted.begin(), sorted.end(),
              [](const PushPull& a, const PushPull& b) { return a.to > b.to; });
    return sorted;
}

}  // namespace

void validate(const ReleaseSchedule& schedule)
{
    for (const PushPull& window : schedule.windows) {
        if (!(window.from < window.to)) {
            throw ConfigError(
                fmt::format("push_pull: from = {:.6g} mm, to = {:.6g} mm; `from` must "
                            "be smaller than `to`",
                            1e3 * window.from, 1e3 * window.to));
        }
        if (!(window.spacing >= smallest_spacing && window.spacing <= largest_spacing)) {
            throw ConfigError(
                fmt::format("push_pull: spacing = {:.6g}; allowed are {} (a push) to "
                            "{} (a pull) times the nominal spacing",
                            window.spacing, smallest_spacing, largest_spacing));
        }
    }
    const std::vector<PushPull> sorted = sorted_from_distal(schedule.windows);
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].to > sorted[i - 1].from) {
            throw ConfigError(fmt::format(
                "push_pull: the windows {:.6g} to {:.6g} mm and {:.6g} to {:.6g} mm overlap",
                1e3 * sorted[i].from, 1e3 * sorted[i].to, 1e3 * sorted[i - 1].from,
                1e3 * sorted[i - 1].to));
        }
    }
}

std::vector<double> ring_positions(const ReleaseSchedule& schedule, double landing_distal,
                                   double nominal_spacing, int num_rings)
{
    const std::vector<PushPull> windows = sorted_from_distal(schedule.windows);
    std::vector<double> positions;
    positions.reserve(static_cast<std::size_t>(num_rings));
    double position = landing_distal;
    std::size_t window = 0;
    for (int ring = 0; ring < num_rings; ++ring) {
        positions.push_back(position);
        // Walk proximally until one nominal spacing of braid is used up, at the rate 1 / lambda.
        double braid_left = nominal_spacing;
        while (braid_left > 0.0) {
            while (window < windows.size() && position <= windows[window].from)
                ++window;
            double lambda = 1.0;
            double stretch_left = std::numeric_limits<double>::infinity();  // at this lambda
            if (window < windows.size()) {
                const bool inside = position <= windows[window].to;
                if (inside) lambda = windows[window].spacing;
                stretch_left = position - (inside ? windows[window].from : windows[window].to);
            }
            const double step = std::min(stretch_left, braid_left * lambda);
            position -= step;
            if (step == braid_left * lambda) break;
            braid_left -= step / lambda;
        }
    }
    return positions;
}

}  // namespace braidzone
