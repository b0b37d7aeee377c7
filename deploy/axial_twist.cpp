#include "deploy/axial_twist.hpp"

#include "core/error.hpp"
#include "core/smooth_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double largest_angle = 720.0 * degree;

/// w, by which the arms of a family turn from one ring to the next [rad].
double arm_angle(const BraidLattice& lattice, std::size_t family)
{
    return (lattice.arm_steps[family] + lattice.stagger) * 2.0 * std::numbers::pi /
           lattice.nodes_per_ring;
}

/// Force-free radius over that without the turn.
double narrowing(const BraidLattice& lattice, double turn)
{
    const double cosine = std::cos(arm_angle(lattice, 1));
    return std::sqrt((1.0 - cosine) / (1.0 - cosine * std::cos(turn)));
}

/// Square of the distance across the axis between the ends of an arm [m^2].
double square_across(double radius, double next_radius, double angle)
{
    const double rise = next_radius - radius;
    return 2.0 * radius * next_radius * (1.0 - std::cos(angle)) + rise * rise;
}

}  // namespace

void validate(const std::vector<AxialTwist>& twists)
{
    for (const AxialTwist& twist : twists) {
        if (!(std::abs(twist.angle) <= largest_angle)) {
            throw ConfigError(fmt::format("twist: angle = {:.6g} deg; allowed are -720 to 720 deg",
                                          twist.angle / degree));
        }
        if (!(twist.half_width > 0.0 && std::isfinite(twist.half_width))) {
            throw ConfigError(fmt::format("twist: half_width = {:.6g} mm; it must be positive",
                                          1e3 * twist.half_width));
        }
        if (!std::isfinite(twist.centre))
            throw ConfigError(fmt::format("twist: centre = {} m is no place", twist.centre));
    }
}

double turn_at(const std::vector<AxialTwist>& twists, double arc_length)
{
    double turn = 0.0;
    for (const AxialTwist& twist : twists) {
        turn += twist.angle * smooth_step((twist.centre + twist.half_width - arc_length) /
                                          (2.0 * twist.half_width));
    }
    return turn;
}

std::vector<double> ring_turns(const std::vector<AxialTwist>& twists, const BraidLattice& lattice,
                               const std::vector<double>& arc_lengths)
{
    std::vector<double> turns;
    if (twists.empty()) return turns;
    const double largest = arm_angle(lattice, 1);
    for (const double arc_length : arc_lengths) {
        turns.push_back(turn_at(twists, arc_length));
        if (turns.size() < 2) continue;
        const double change = std::abs(turns.back() - turns[turns.size() - 2]);
        if (change < largest) continue;
        throw ConfigError(fmt::format(
            "twist: at {:.6g} mm neighbouring rings would be turned by {:.4g} deg against each "
            "other; below {:.4g} deg, where one family of wires would lie along the vessel, is "
            "allowed: lower the angle, or widen half_width",
            1e3 * arc_length, change / degree, largest / degree));
    }
    return turns;
}

BraidLattice twisted(const BraidLattice& lattice, const std::vector<double>& turns)
{
    BraidLattice result = lattice;
    if (turns.empty()) return result;
    const auto gap_turn = [&](int gap) {
        return turns[static_cast<std::size_t>(gap + 1)] - turns[static_cast<std::size_t>(gap)];
    };
    result.rest_radii.clear();
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const int before = std::max(0, ring - 1), behind = std::min(ring, lattice.num_rings - 2);
        result.rest_radii.push_back(
            lattice.rest_radius(ring) * 0.5 *
            (narrowing(lattice, gap_turn(before)) + narrowing(lattice, gap_turn(behind))));
    }
    for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
        std::array<double, 2> lengths{};
        for (std::size_t family : {0u, 1u}) {
            const double angle = arm_angle(lattice, family);
            const double square =
                lattice.arm_length * lattice.arm_length +
                square_across(result.rest_radius(ring), result.rest_radius(ring + 1),
                              angle + gap_turn(ring)) -
                square_across(lattice.rest_radius(ring), lattice.rest_radius(ring + 1), angle);
            lengths[family] = std::sqrt(square);
        }
        result.arm_lengths.push_back(lengths);
    }
    return result;
}

}  // namespace braidzone
