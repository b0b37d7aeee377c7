#include "deploy/release_schedule.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace braidzone {

namespace {

constexpr double smallest_spacing = 0.05;
constexpr double largest_pull = 2.0;
/// Of a table: a braid in its catheter is 2 to 3 times as long as at nominal diameter.
constexpr double largest_spacing = 4.0;

void validate_windows(const std::vector<PushPull>& windows)
{
    for (const PushPull& window : windows) {
        if (!(window.from < window.to)) {
            throw ConfigError(
                fmt::format("push_pull: from = {:.6g} mm, to = {:.6g} mm; `from` must "
                            "be smaller than `to`",
                            1e3 * window.from, 1e3 * window.to));
        }
        if (!(window.spacing >= smallest_spacing && window.spacing <= largest_pull)) {
            throw ConfigError(
                fmt::format("push_pull: spacing = {:.6g}; allowed are {} (a push) to "
                            "{} (a pull) times the nominal spacing",
                            window.spacing, smallest_spacing, largest_pull));
        }
    }
    std::vector<PushPull> sorted = windows;
    std::sort(sorted.begin(), sorted.end(),
              [](const PushPull& a, const PushPull& b) { return a.to > b.to; });
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].to > sorted[i - 1].from) {
            throw ConfigError(fmt::format(
                "push_pull: the windows {:.6g} to {:.6g} mm and {:.6g} to {:.6g} mm overlap",
                1e3 * sorted[i].from, 1e3 * sorted[i].to, 1e3 * sorted[i - 1].from,
                1e3 * sorted[i - 1].to));
        }
    }
}

void validate_table(const std::vector<SpacingPoint>& table)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (!(table[i].spacing >= smallest_spacing && table[i].spacing <= largest_spacing)) {
            throw ConfigError(fmt::format(
                "spacing_table: lambda = {:.6g} at {:.6g} mm; allowed are {} to {} times the "
                "nominal spacing",
                table[i].spacing, 1e3 * table[i].arc_length, smallest_spacing, largest_spacing));
        }
        if (i > 0 && !(table[i].arc_length > table[i - 1].arc_length)) {
            throw ConfigError(
                fmt::format("spacing_table: {:.6g} mm follows {:.6g} mm; arc lengths must increase",
                            1e3 * table[i].arc_length, 1e3 * table[i - 1].arc_length));
        }
    }
}

/// lambda over a stretch of the centerline between two places where its slope may change.
struct Stretch {
    double length = 0.0;         ///< [m]; may be infinite where lambda is constant
    double spacing = 1.0;        ///< lambda at the distal end
    double slope_inwards = 0.0;  ///< change of lambda towards the proximal end [1/m]
};

/// The schedule as a function of place, walked from distal to proximal.
class SpacingFunction {
public:
    explicit SpacingFunction(const ReleaseSchedule& schedule) : table_(schedule.table)
    {
        for (const PushPull& window : schedule.windows) {
            windows_.push_back(window);
            breaks_.insert(breaks_.end(), {window.from, window.to});
        }
        for (const SpacingPoint& point : table_)
            breaks_.push_back(point.arc_length);
        std::sort(breaks_.begin(), breaks_.end());
    }

    /// From a place down to the next break.
    Stretch below(double position) const
    {
        const auto next = std::lower_bound(breaks_.begin(), breaks_.end(), position);
        const double end =
            next == breaks_.begin() ? -std::numeric_limits<double>::infinity() : *(next - 1);
        const double factor = window_factor(position);
        const double here = factor * table_value(position);
        if (!std::isfinite(end)) return {position - end, here, 0.0};
        const double there = factor * table_value(end);
        return {position - end, here, (there - here) / (position - end)};
    }

private:
    double window_factor(double position) const
    {
        for (const PushPull& window : windows_) {
            if (position > window.from && position <= window.to) return window.spacing;
        }
        return 1.0;
    }

    double table_value(double position) const
    {
        if (table_.empty()) return 1.0;
        if (position <= table_.front().arc_length) return table_.front().spacing;
        if (position >= table_.back().arc_length) return table_.back().spacing;
        const auto above =
            std::upper_bound(table_.begin(), table_.end(), position,
                             [](double s, const SpacingPoint& p) { return s < p.arc_length; });
        const auto below = above - 1;
        return std::lerp(below->spacing, above->spacing,
                         (position - below->arc_length) / (above->arc_length - below->arc_length));
    }

    std::vector<PushPull> windows_;
    std::vector<SpacingPoint> table_;
    std::vector<double> breaks_;  ///< increasing
};

/// Way over which `braid` of nominal length is laid down where lambda = a + b x: the inverse of
/// log(1 + b x / a) / b, which is a (exp(b braid) - 1) / b.
double way_for(double braid, const Stretch& stretch)
{
    const double exponent = stretch.slope_inwards * braid;
    const double growth = exponent == 0.0 ? 1.0 : std::expm1(exponent) / exponent;
    return stretch.spacing * braid * growth;
}

/// Nominal length of braid that a whole stretch takes.
double braid_on(const Stretch& stretch)
{
    const double change = stretch.slope_inwards * stretch.length / stretch.spacing;
    const double mean = change == 0.0 ? 1.0 : std::log1p(change) / change;
    return stretch.length / stretch.spacing * mean;
}

}  // namespace

void validate(const ReleaseSchedule& schedule)
{
    validate_windows(schedule.windows);
    validate_table(schedule.table);
    if (!(schedule.sliding >= 0.0 && schedule.sliding <= 1.0)) {
        throw ConfigError(fmt::format(
            "sliding = {:.6g}; allowed are 0 (rings stay at the nominal spacing) to 1 (they take "
            "the force-free spacing)",
            schedule.sliding));
    }
    validate(schedule.twists);
    validate(schedule.incomplete_openings);
    if (schedule.table.empty()) return;
    if (!schedule.windows.empty()) {
        throw ConfigError(
            "spacing_table is the whole schedule; push_pull cannot stand beside it: keep one of "
            "them");
    }
    if (schedule.sliding > 0.0) {
        throw ConfigError(
            "spacing_table is the whole schedule; sliding, which release = \"force_free\" is in "
            "full, cannot stand beside it: keep one of them");
    }
}

std::vector<double> ring_positions(const ReleaseSchedule& schedule, double landing_distal,
                                   const std::vector<double>& nominal_spacings)
{
    const SpacingFunction spacing(schedule);
    std::vector<double> positions = {landing_distal};
    for (const double nominal_spacing : nominal_spacings) {
        double position = positions.back();
        double braid_left = nominal_spacing;
        for (;;) {
            const Stretch stretch = spacing.below(position);
            const double way = way_for(braid_left, stretch);
            if (way < stretch.length) {
                positions.push_back(position - way);
                break;
            }
            braid_left = std::max(0.0, braid_left - braid_on(stretch));
            position -= stretch.length;
        }
    }
    return positions;
}

std::vector<double> ring_positions(const ReleaseSchedule& schedule, double landing_distal,
                                   double nominal_spacing, int num_rings)
{
    return ring_positions(
        schedule, landing_distal,
        std::vector<double>(static_cast<std::size_t>(std::max(0, num_rings - 1)), nominal_spacing));
}

}  // namespace braidzone
