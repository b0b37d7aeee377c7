#include "export/lattice_stability.hpp"

#include "export/lattice_hemoflow.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace braidzone {

namespace {

constexpr double lowest_relaxation_time = 0.51;       // of the plain BGK collision
constexpr double lowest_relaxation_time_mrt = 0.508;  // LBPM's: 0.508 runs, 0.502 does not
constexpr double highest_density_error = 0.03;
constexpr double highest_proposed_velocity_lu = 0.1;  // a Mach number of 0.17
constexpr double reserve = 1.05;                      // a proposal keeps that far from the limits

/// What a target makes of the lattice, and what limits it.
struct TargetFlow {
    double viscosity = 0.0;  ///< kinematic, that of its fluid [m^2/s]
    double lowest_relaxation_time = 0.0;
    double drag_speed = 0.0;       ///< nu D dx of the device's fullest node, with our fluid [m/s]
    double mean_drag_speed = 0.0;  ///< the same, mean weighted with D
    double inertia_lu = 0.0;       ///< b of it
    bool velocity_is_fixed = false;
    bool is_explicit = false;     ///< its force
    bool needs_porosity = false;  ///< a < 1 / (3 nu_lu)
};

TargetFlow flow_in(LatticeTarget target, const LatticeNodes& nodes, const Fluid& fluid)
{
    TargetFlow result;
    const double h = nodes.grid.spacing;
    const bool is_hemoflow = target == LatticeTarget::hemoflow;
    result.viscosity = is_hemoflow ? hemoflow_viscosity : fluid.viscosity / fluid.density;
    result.lowest_relaxation_time =
        target == LatticeTarget::lbpm ? lowest_relaxation_time_mrt : lowest_relaxation_time;
    result.velocity_is_fixed = result.is_explicit = is_hemoflow;
    result.needs_porosity = target == LatticeTarget::openlb;
    if (!traits_of(target).has_linear || nodes.darcy.empty()) return result;
    result.drag_speed = fluid.viscosity / fluid.density * h *
                        *std::max_element(nodes.darcy.begin(), nodes.darcy.end());
    double sum = 0.0, weighted = 0.0;
    for (const double darcy : nodes.darcy) {
        sum += darcy;
        weighted += darcy * darcy;
    }
    if (sum > 0.0) result.mean_drag_speed = fluid.viscosity / fluid.density * h * weighted / sum;
    if (traits_of(target).quadratic_limit == nullptr || is_hemoflow)
        result.inertia_lu =
            0.5 * h * *std::max_element(nodes.forchheimer.begin(), nodes.forchheimer.end());
    return result;
}

/// The largest velocity, in lattice units, that keeps the density's error and OpenLB's porosity.
double highest_velocity(const TargetFlow& target, double spacing, double peak_velocity)
{
    double highest = highest_proposed_velocity_lu;
    if (!(target.drag_speed > 0.0)) return highest;
    const double square = highest_density_error / 3.0 * peak_velocity / target.mean_drag_speed;
    highest = std::min(highest, std::sqrt(square) / reserve);
    if (target.needs_porosity) {
        const double largest =
            peak_velocity * peak_velocity * spacing / (3.0 * target.viscosity * target.drag_speed);
        highest = std::min(highest, std::sqrt(largest) / reserve);
    }
    return highest;
}

/// The spacing up to which the relaxation time stays above its limit.
double widest_spacing(const TargetFlow& target, double peak_velocity, double velocity_lu)
{
    return 3.0 * target.viscosity * velocity_lu /
           ((target.lowest_relaxation_time - 0.5) * peak_velocity * reserve);
}

std::string spacing_change(double spacing)
{
    return fmt::format("grid.spacing = \"{:.3g} mm\"", 1e3 * spacing);
}

/// HemoFlow's velocity is its own; the peak velocity sets the time step.
StableUnits proposal_at_fixed_velocity(const TargetFlow& target, const StableUnits& given)
{
    StableUnits result = given;
    const double for_density = target.mean_drag_speed * given.velocity_lu * 3.0 *
                               given.velocity_lu / highest_density_error;
    const double for_force = target.drag_speed * given.velocity_lu /
                             (hemoflow_most_drag_lu - 2.0 * target.inertia_lu * given.velocity_lu);
    const double slowest = std::max(for_density, for_force);
    std::vector<std::string> changes;
    if (!(given.peak_velocity > slowest)) {
        result.peak_velocity = reserve * slowest;
        changes.push_back(fmt::format("peak_velocity = \"{:.3g} m/s\"", result.peak_velocity));
    }
    const double widest = widest_spacing(target, result.peak_velocity, result.velocity_lu);
    if (!(given.spacing < reserve * widest)) {
        result.spacing = widest;
        changes.push_back(spacing_change(widest));
    }
    result.changes = fmt::format("{}", fmt::join(changes, " and "));
    return result;
}

StableUnits proposal_at_free_velocity(const TargetFlow& target, const StableUnits& given)
{
    StableUnits result = given;
    std::vector<std::string> changes;
    const double highest = highest_velocity(target, given.spacing, given.peak_velocity);
    if (given.velocity_lu > reserve * highest && target.drag_speed > 0.0)
        result.velocity_lu = highest;
    double widest = widest_spacing(target, given.peak_velocity, result.velocity_lu);
    if (!(given.spacing < reserve * widest)) {
        const double needed = result.velocity_lu * given.spacing / widest;
        result.velocity_lu = std::max(result.velocity_lu, std::min(needed, highest));
        widest = widest_spacing(target, given.peak_velocity, result.velocity_lu);
    }
    if (result.velocity_lu != given.velocity_lu)
        changes.push_back(fmt::format("velocity_lu = {:.3g}", result.velocity_lu));
    if (!(given.spacing < reserve * widest)) {
        result.spacing = widest;
        changes.push_back(spacing_change(widest));
    }
    result.changes = fmt::format("{}", fmt::join(changes, " and "));
    return result;
}

}  // namespace

TargetStability stability_of(LatticeTarget target, const LatticeNodes& nodes, const Fluid& fluid,
                             const LatticeFlowOptions& flow)
{
    const TargetFlow own = flow_in(target, nodes, fluid);
    StableUnits given{nodes.grid.spacing, flow.peak_velocity, flow.velocity_lu, 0.0, ""};
    if (own.velocity_is_fixed) given.velocity_lu = 2.0 * hemoflow_velocity_lu;

    TargetStability result;
    result.target = target;
    result.velocity_lu = given.velocity_lu;
    result.time_step = given.velocity_lu * given.spacing / given.peak_velocity;
    const double viscosity_lu = own.viscosity * result.time_step / (given.spacing * given.spacing);
    result.relaxation_time_lu = 3.0 * viscosity_lu + 0.5;
    result.largest_drag_lu = own.drag_speed * result.time_step / given.spacing;
    result.density_error =
        3.0 * own.mean_drag_speed * result.time_step / given.spacing * given.velocity_lu;
    if (!(result.relaxation_time_lu > own.lowest_relaxation_time)) {
        result.doubts.push_back(fmt::format(
            "relaxation time {:.4g} is not above {:.4g}: {}", result.relaxation_time_lu,
            own.lowest_relaxation_time,
            target == LatticeTarget::lbpm ? "its MRT collision may diverge"
                                          : "the plain BGK collision is unstable (TRT, MRT and "
                                            "regularised ones bear less)"));
    }
    if (!(result.density_error < highest_density_error)) {
        result.doubts.push_back(
            fmt::format("flow at its fastest through the device would change the density by {:.2g} "
                        "%, allowed is {:.2g} %",
                        100.0 * result.density_error, 100.0 * highest_density_error));
    }
    if (own.needs_porosity && !(result.largest_drag_lu * 3.0 * viscosity_lu < 1.0)) {
        result.doubts.push_back(
            fmt::format("a drag of {:.3g} a time step is beyond what a porosity expresses, {:.3g}",
                        result.largest_drag_lu, 1.0 / (3.0 * viscosity_lu)));
    }
    const double whole_drag = result.largest_drag_lu + 2.0 * own.inertia_lu * given.velocity_lu;
    if (own.is_explicit && !(whole_drag < hemoflow_most_drag_lu)) {
        result.doubts.push_back(
            fmt::format("its explicit force diverges with a drag of {:.3g} a time step, allowed is "
                        "{:.3g}",
                        whole_drag, hemoflow_most_drag_lu));
    }
    result.proposal = given;
    if (!result.doubts.empty()) {
        result.proposal = own.velocity_is_fixed ? proposal_at_fixed_velocity(own, given)
                                                : proposal_at_free_velocity(own, given);
    }
    result.proposal.time_step =
        result.proposal.velocity_lu * result.proposal.spacing / result.proposal.peak_velocity;
    return result;
}

std::vector<std::string> stability_notes(const std::vector<TargetStability>& targets)
{
    // In the order of the targets, those with the same doubt and advice together.
    std::vector<std::pair<std::string, std::vector<std::string>>> shared;
    for (const TargetStability& target : targets) {
        for (const std::string& doubt : target.doubts) {
            const std::string sentence = fmt::format("{}; take {}", doubt, target.proposal.changes);
            auto found = std::find_if(shared.begin(), shared.end(),
                                      [&](const auto& entry) { return entry.first == sentence; });
            if (found == shared.end()) found = shared.insert(shared.end(), {sentence, {}});
            found->second.push_back(target_name(target.target));
        }
    }
    std::vector<std::string> notes;
    for (const auto& [sentence, names] : shared)
        notes.push_back(fmt::format("lattice ({}): {}", fmt::join(names, ", "), sentence));
    return notes;
}

}  // namespace braidzone
