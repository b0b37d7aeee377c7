#include "deploy/calibration.hpp"

#include "core/error.hpp"
#include "core/even_curve.hpp"

#include <Eigen/Dense>
#include <boost/math/distributions/students_t.hpp>
#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace braidzone {

namespace {

/// Largest force times this is the least standard error of a point, see `calibrate`.
constexpr double smallest_relative_error = 0.01;

/// Step in the logarithm of the ratio for its derivative: large against the press test's tolerance.
constexpr double ratio_step = 0.02;

/// States of the simulated press test over the stroke.
constexpr int num_states = 20;

/// Coarsest net that still has the shape of a tube, and the coarsest that it can be compared with.
constexpr int coarsest_net = 6;
constexpr int coarsest_fitted_net = 8;

/// A net's error beyond which a finer one is advised.
constexpr double coarse_net_error = 0.1;

/// Beyond this the two coefficients cannot be told apart: one of them may be twice or half of what
/// it is.
constexpr double undetermined_error = 0.35;

/// The simulated press test as a function of the ratio of the coefficients.
class UnitPress {
public:
    UnitPress(const FlowDiverter& device, PressOptions options, const ForceCurve& measured)
        : device_(device), options_(std::move(options)), measured_(measured)
    {
        device_.forces = ForceSource::springs;
        options_.surface_factor = options_.radial_factor = 1.0;
        options_.stroke = measured.points.back().displacement;
        options_.step = options_.stroke / num_states;
    }

    /// G at the measured displacements, for c_surface = 1 N/m [m].
    const std::vector<double>& curve(double log_ratio)
    {
        const auto known = curves_.find(log_ratio);
        if (known != curves_.end()) return known->second;
        device_.surface_coefficient = 1.0;
        device_.radial_coefficient = std::exp(log_ratio);
        std::vector<double> forces;
        for (const PressState& state : press(press_network(device_, options_).network, options_))
            forces.push_back(state.force);
        std::vector<double> values;
        for (const ForcePoint& point : measured_.points)
            values.push_back(value_on_even_curve(forces, options_.step, point.displacement));
        return curves_.emplace(log_ratio, values).first->second;
    }

private:
    FlowDiverter device_;
    PressOptions options_;
    const ForceCurve& measured_;
    std::map<double, std::vector<double>> curves_;
};

/// Residuals (F_measured - F) / s over (log c_surface, log ratio).
class PressResiduals : public ceres::CostFunction {
public:
    PressResiduals(UnitPress& press, const ForceCurve& measured, double standard_error)
        : press_(press), measured_(measured), standard_error_(standard_error)
    {
        set_num_residuals(static_cast<int>(measured.points.size()));
        mutable_parameter_block_sizes()->push_back(2);
    }

    bool Evaluate(double const* const* parameters, double* residuals,
                  double** jacobians) const override
    {
        const double surface = std::exp(parameters[0][0]), log_ratio = parameters[0][1];
        const std::vector<double> here = press_.curve(log_ratio);
        const bool wants_slope = jacobians != nullptr && jacobians[0] != nullptr;
        std::vector<double> above, below;
        if (wants_slope) {
            above = press_.curve(log_ratio + ratio_step);
            below = press_.curve(log_ratio - ratio_step);
        }
        for (std::size_t i = 0; i < here.size(); ++i) {
            residuals[i] = (measured_.points[i].force - surface * here[i]) / standard_error_;
            if (!wants_slope) continue;
            jacobians[0][2 * i] = -surface * here[i] / standard_error_;
            jacobians[0][2 * i + 1] =
                -surface * (above[i] - below[i]) / (2.0 * ratio_step) / standard_error_;
        }
        return true;
    }

private:
    UnitPress& press_;
    const ForceCurve& measured_;
    double standard_error_;
};

/// The best coefficients on one net.
struct NetFit {
    Eigen::Vector2d logs;  ///< log c_surface, log c_radial
    Eigen::Matrix2d covariance;
    double reduced_chi_square = 0.0;
    std::vector<double> force;  ///< at the curve's points [N]
};

/// log c_radial is the sum of both parameters.
const Eigen::Matrix2d logs_of_parameters = (Eigen::Matrix2d() << 1.0, 0.0, 1.0, 1.0).finished();

/// Where the fit begins: the device's ratio, and the factor that suits it best, in closed form.
Eigen::Vector2d first_parameters(UnitPress& unit_press, const FlowDiverter& device,
                                 const ForceCurve& measured)
{
    const double ratio = std::log(device.radial_coefficient / device.surface_coefficient);
    const std::vector<double> unit = unit_press.curve(ratio);
    double products = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        products += unit[i] * measured.points[i].force;
        squares += unit[i] * unit[i];
    }
    if (!(products > 0.0)) throw InputError("the measured curve has no force in it");
    return {std::log(products / squares), ratio};
}

NetFit fit_on_net(const FlowDiverter& device, PressOptions options, int nodes_per_ring,
                  const ForceCurve& measured, double standard_error)
{
    options.nodes_per_ring = nodes_per_ring;
    UnitPress unit_press(device, options, measured);
    Eigen::Vector2d x = first_parameters(unit_press, device, measured);
    ceres::Problem problem;
    problem.AddResidualBlock(new PressResiduals(unit_press, measured, standard_error), nullptr,
                             x.data());
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.logging_type = ceres::SILENT;
    solver.max_num_iterations = 30;
    solver.function_tolerance = 1e-5;
    solver.parameter_tolerance = 1e-4;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    if (summary.termination_type != ceres::CONVERGENCE) {
        throw ConvergenceError(fmt::format(
            "the fit of the spring coefficients did not converge: {}", summary.message));
    }

    const int num_points = static_cast<int>(measured.points.size());
    Eigen::VectorXd residuals(num_points);
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> jacobian(num_points, 2);
    const double* parameters[] = {x.data()};
    double* jacobians[] = {jacobian.data()};
    PressResiduals(unit_press, measured, standard_error)
        .Evaluate(parameters, residuals.data(), jacobians);

    NetFit fit;
    fit.logs = logs_of_parameters * x;
    fit.reduced_chi_square = residuals.squaredNorm() / (num_points - 2);
    fit.covariance = logs_of_parameters * (jacobian.transpose() * jacobian).inverse() *
                     logs_of_parameters.transpose() * std::max(1.0, fit.reduced_chi_square);
    for (double value : unit_press.curve(x[1]))
        fit.force.push_back(std::exp(x[0]) * value);
    return fit;
}

/// A net about half as fine, with an even number of crossings around.
int coarser_net(int nodes_per_ring)
{
    return std::max(coarsest_net, 2 * static_cast<int>(std::lround(nodes_per_ring / 4.0)));
}

/// @param i  0: c_surface, 1: c_radial
Estimate estimate(const NetFit& fine, const NetFit& coarse, double refinement, double t, int i)
{
    Estimate result;
    result.value = std::exp(fine.logs[i]);
    result.relative_error = std::sqrt(fine.covariance(i, i));
    result.discretisation_error = std::abs(fine.logs[i] - coarse.logs[i]) / (refinement - 1.0);
    const double half_width = std::hypot(t * result.relative_error, result.discretisation_error);
    result.lower = std::exp(fine.logs[i] - half_width);
    result.upper = std::exp(fine.logs[i] + half_width);
    return result;
}

std::string statement_on(const Calibration& fit)
{
    const auto known = [](const Estimate& e) { return e.relative_error < undetermined_error; };
    std::string text;
    if (known(fit.surface) && known(fit.radial)) {
        text = "The curve determines both coefficients.";
    } else if (known(fit.surface)) {
        text = "The curve determines c_surface; c_radial hardly matters to it.";
    } else if (known(fit.radial)) {
        text = "The curve determines c_radial; c_surface hardly matters to it.";
    } else {
        text = fmt::format(
            "The curve determines a combination of the two coefficients only (correlation {:.2f}); "
            "a longer stroke, which crushes the device after bending it, would tell them apart.",
            fit.correlation);
    }
    if (std::max(fit.surface.discretisation_error, fit.radial.discretisation_error) >
        coarse_net_error) {
        text +=
            " The net is coarse for it: a larger press.nodes_per_ring would narrow the intervals.";
    }
    if (fit.reduced_chi_square > 4.0) {
        text += fmt::format(
            " The model misses the curve by {:.2g} times its error: notch, head or device are not "
            "as stated, or the coefficients stand for more than they can.",
            std::sqrt(fit.reduced_chi_square));
    }
    return text;
}

}  // namespace

Calibration calibrate(const FlowDiverter& device, const PressOptions& options,
                      const ForceCurve& measured)
{
    if (!(device.surface_coefficient > 0.0 && device.radial_coefficient > 0.0 &&
          device.reference_node_area > 0.0)) {
        throw InputError(
            "calibration begins with the device's spring coefficients; give "
            "device.surface_coefficient, radial_coefficient and reference_node_area");
    }
    Calibration result;
    result.nodes_per_ring =
        options.nodes_per_ring > 0 ? options.nodes_per_ring : device.num_wires / 2;
    if (!(result.nodes_per_ring >= coarsest_fitted_net)) {
        throw ConfigError(fmt::format(
            "press.nodes_per_ring = {} is too coarse for a calibration; at least {} are needed, so "
            "that a coarser net can tell the error",
            result.nodes_per_ring, coarsest_fitted_net));
    }
    result.coarse_nodes_per_ring = coarser_net(result.nodes_per_ring);
    double largest = 0.0;
    for (const ForcePoint& point : measured.points)
        largest = std::max(largest, point.force);
    result.standard_error = std::max(smallest_relative_error * largest,
                                     measured.deviation / std::sqrt(measured.num_repeats));

    const auto fit_on = [&](int nodes_per_ring) {
        return fit_on_net(device, options, nodes_per_ring, measured, result.standard_error);
    };
    const NetFit coarse = fit_on(result.coarse_nodes_per_ring);
    const NetFit fine = fit_on(result.nodes_per_ring);
    const double refinement =
        static_cast<double>(result.nodes_per_ring) / result.coarse_nodes_per_ring;
    const double freedom = static_cast<double>(measured.points.size()) - 2.0;
    const double t = boost::math::quantile(boost::math::students_t(freedom), 0.975);
    result.surface = estimate(fine, coarse, refinement, t, 0);
    result.radial = estimate(fine, coarse, refinement, t, 1);
    result.correlation =
        fine.covariance(0, 1) / std::sqrt(fine.covariance(0, 0) * fine.covariance(1, 1));
    result.reduced_chi_square = fine.reduced_chi_square;
    result.fitted_force = fine.force;
    result.statement = statement_on(result);
    return result;
}

}  // namespace braidzone
