#include "discrepancy/press_response.hpp"

#include "core/error.hpp"
#include "core/even_curve.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace braidzone {
namespace {

/// Factors of 0.3 to 3.3 in steps of 1.5.
constexpr double largest_log_ratio = 1.2, log_ratio_step = 0.4;
constexpr std::array<double, 2> frictions = {0.2, 0.4};
/// Way beyond the last measured displacement, for an offset of the head's zero [m].
constexpr double margin = 0.25e-3;
/// A device that does not come to rest within these is taken to give way: to find out otherwise
/// would take longer than all other press tests.
constexpr int most_iterations = 100, most_halvings = 2;

/// A ratio of forces tells nothing where they are less than this share of the largest.
constexpr double least_force = 1e-3;

/// Forces at the states that were reached.
struct Run {
    PressModel model;
    std::vector<double> force = {};
    std::string failure = {};
};

void simulate(Run& run)
{
    try {
        const PressNetwork pressed = press_network(run.model.device, run.model.options);
        press(pressed.network, run.model.options,
              [&](const PressState& state) { run.force.push_back(state.force); });
    } catch (const ConvergenceError& error) {
        run.failure = error.what();
    }
}

/// ln of one curve over another; where either has no force to speak of as at the next state.
std::vector<double> log_ratio_of(const std::vector<double>& above, const std::vector<double>& below,
                                 std::size_t size)
{
    const double least = least_force * *std::max_element(below.begin(), below.end());
    std::vector<double> result(size);
    const std::size_t last = std::min({size, above.size(), below.size()});
    for (std::size_t i = last; i-- > 0;) {
        const bool tells = above[i] > least && below[i] > least;
        if (tells) {
            result[i] = std::log(above[i] / below[i]);
        } else {
            result[i] = i + 1 < last ? result[i + 1] : 0.0;
        }
    }
    for (std::size_t i = last; i < size; ++i)
        result[i] = last > 0 ? result[last - 1] : 0.0;
    return result;
}

double ratio_of(const PressModel& model)
{
    return model.options.radial_factor / model.options.surface_factor;
}

/// What friction does to the force: `PressResponse::friction` and `slip`.
struct FrictionEffect {
    std::vector<double> slope;
    double slip = 0.0;
};

/// Parabola through ln M / friction of all runs, by least squares, and the scatter about it.
FrictionEffect friction_effect_of(const std::vector<Run>& runs, const std::vector<double>& none,
                                  double base_friction, std::size_t size)
{
    std::vector<Eigen::Vector3d> rows;
    std::vector<double> slopes, weights;
    for (const Run& run : runs) {
        const double change = run.model.options.friction - base_friction;
        const std::vector<double> logs = log_ratio_of(run.force, none, size);
        for (std::size_t i = 1; i < std::min(size, run.force.size()); ++i) {
            const double x = static_cast<double>(i) / static_cast<double>(size);
            rows.emplace_back(1.0, x, x * x);
            slopes.push_back(logs[i] / change);
            weights.push_back(change);
        }
    }
    FrictionEffect result{std::vector<double>(size, 0.0)};
    if (rows.size() < 4) return result;
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(rows.size()), 3);
    Eigen::VectorXd right(matrix.rows());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        matrix.row(row) = weights[i] * rows[i];
        right[row] = weights[i] * slopes[i];
    }
    const Eigen::Vector3d fit = matrix.colPivHouseholderQr().solve(right);
    for (std::size_t i = 0; i < size; ++i) {
        const double x = static_cast<double>(i) / static_cast<double>(size);
        result.slope[i] = fit[0] + x * (fit[1] + x * fit[2]);
    }
    double squares = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        squares += std::pow(slopes[i] - rows[i].dot(fit), 2);
    result.slip = std::sqrt(squares / static_cast<double>(rows.size() - 3));
    return result;
}

/// The runs that a response takes: the case as it is on its own net and on the coarse one, then
/// ratios, then frictions.
std::vector<Run> planned_runs(const PressModel& base, const PressResponseOptions& options)
{
    if (!options.with_changes) return {{base}};
    PressModel coarse = base;
    const int own =
        base.options.nodes_per_ring > 0 ? base.options.nodes_per_ring : base.device.num_wires / 2;
    coarse.options.nodes_per_ring = std::min(own, options.coarse_nodes_per_ring);
    std::vector<Run> runs = {{base}, {coarse}};
    for (const double log_ratio : press_log_ratios()) {
        if (log_ratio == 0.0) continue;
        Run run{coarse};
        run.model.options.radial_factor *= std::exp(log_ratio);
        runs.push_back(run);
    }
    for (const double friction : frictions) {
        Run run{coarse};
        run.model.options.friction += friction;
        runs.push_back(run);
    }
    return runs;
}

}  // namespace

std::vector<double> press_log_ratios()
{
    std::vector<double> all;
    const int half = static_cast<int>(std::lround(largest_log_ratio / log_ratio_step));
    for (int i = -half; i <= half; ++i)
        all.push_back(i * log_ratio_step);
    return all;
}

PressResponse make_press_response(const PressModel& base, double stroke,
                                  const PressResponseOptions& options)
{
    PressResponse response;
    response.base = base;
    response.base.options.stroke = stroke + margin;
    response.base.options.step = base.options.load_step;
    response.base.options.max_iterations = most_iterations;
    response.base.options.max_halvings = most_halvings;
    response.step = response.base.options.step;
    response.force_scale = press_network(base.device, base.options).force_scale;
    std::vector<Run> runs = planned_runs(response.base, options);
    std::mutex one_call;
    int done = 0;
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
        simulate(runs[i]);
        const std::scoped_lock lock(one_call);
        if (options.on_progress) options.on_progress(++done, static_cast<int>(runs.size()));
    });
    response.force = runs[0].force;
    const std::size_t size = response.force.size();
    if (static_cast<double>(size - 1) * response.step < stroke - response.step) {
        throw ConvergenceError(
            fmt::format("{}; the measured curve goes to {:.6g} mm", runs[0].failure, 1e3 * stroke));
    }
    if (!options.with_changes) {
        response.ratio.assign(press_log_ratios().size(), std::vector<double>(size, 0.0));
        response.friction.assign(size, 0.0);
        return response;
    }
    const std::vector<double>& coarse = runs[1].force;
    auto next = runs.cbegin() + 2;
    for (const double log_ratio : press_log_ratios()) {
        response.ratio.push_back(log_ratio == 0.0 ? std::vector<double>(size, 0.0)
                                                  : log_ratio_of((next++)->force, coarse, size));
    }
    const FrictionEffect friction =
        friction_effect_of({next, runs.cend()}, coarse, base.options.friction, size);
    response.friction = friction.slope;
    response.slip = friction.slip;
    return response;
}

std::vector<double> press_forces(const PressResponse& response, const PressModel& model,
                                 const std::vector<double>& displacements)
{
    const PressModel& base = response.base;
    const double log_ratio = std::log(ratio_of(model) / ratio_of(base));
    if (!(std::abs(log_ratio) <= largest_log_ratio)) {
        throw InputError(fmt::format(
            "radial springs over arms are {:.6g} times those of the press file; tabulated are "
            "{:.3g} to {:.3g} times",
            std::exp(log_ratio), std::exp(-largest_log_ratio), std::exp(largest_log_ratio)));
    }
    if (!(model.options.friction >= 0.0))
        throw InputError(fmt::format("friction = {:.6g} is negative", model.options.friction));
    double factor =
        response.force_scale * model.options.surface_factor / base.options.surface_factor;
    if (model.device.forces == ForceSource::wire_theory)
        factor *= std::pow(model.device.wire_diameter / base.device.wire_diameter, 4);
    const double friction = model.options.friction - base.options.friction;
    std::vector<double> at_states;
    for (std::size_t i = 0; i < response.force.size(); ++i) {
        std::vector<double> logs;
        for (const std::vector<double>& curve : response.ratio)
            logs.push_back(curve[i]);
        at_states.push_back(
            factor * response.force[i] *
            std::exp(value_on_even_curve(logs, log_ratio_step, log_ratio + largest_log_ratio) +
                     friction * response.friction[i]));
    }
    std::vector<double> shown;
    for (const double displacement : displacements) {
        const double x = displacement - model.options.reading.zero_offset;
        const double force =
            x > 0.0 ? value_on_even_curve(at_states, response.step, x) : at_states[0];
        shown.push_back(
            as_read({x, force}, model.options.reading, model.device.nominal_diameter).force);
    }
    return shown;
}

}  // namespace braidzone
