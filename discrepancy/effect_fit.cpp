#include "discrepancy/effect_fit.hpp"

#include "core/error.hpp"
#include "discrepancy/laplace_evidence.hpp"

#include <Eigen/Dense>
#include <ceres/ceres.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace braidzone {
namespace {

std::size_t index(Eigen::Index i)
{
    return static_cast<std::size_t>(i);
}

/// An effect's residuals as a function of its scaled parameters; remembers what it has computed.
class EffectResiduals {
public:
    EffectResiduals(const Effect& effect, const FitProblem& problem)
        : effect_(effect), problem_(problem), parameters_(effect.parameters(problem.setting))
    {
    }

    const std::vector<EffectParameter>& parameters() const { return parameters_; }
    Eigen::Index size() const { return static_cast<Eigen::Index>(parameters_.size()); }

    std::vector<double> values(const Eigen::VectorXd& x) const
    {
        std::vector<double> values;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const EffectParameter& p = parameters_[index(i)];
            values.push_back(std::clamp(p.prior_mean + p.prior_sd * x[i], p.lower, p.upper));
        }
        return values;
    }

    Eigen::VectorXd scaled(const std::vector<double>& values) const
    {
        Eigen::VectorXd x(size());
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const EffectParameter& p = parameters_[index(i)];
            x[i] = (std::clamp(values[index(i)], p.lower, p.upper) - p.prior_mean) / p.prior_sd;
        }
        return x;
    }

    double upper(Eigen::Index i) const
    {
        const EffectParameter& p = parameters_[index(i)];
        return (p.upper - p.prior_mean) / p.prior_sd;
    }

    /// Residuals [m] at several places, in parallel. An empty vector where the effect cannot be
    /// simulated.
    std::vector<Eigen::VectorXd> at(const std::vector<Eigen::VectorXd>& places)
    {
        std::vector<Eigen::VectorXd> results(places.size());
        std::vector<std::string> failures(places.size());
        std::vector<char> is_new(places.size(), 0);
        tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
            const auto known = known_.find(values(places[i]));
            if (known != known_.end()) {
                results[i] = known->second;
                return;
            }
            is_new[i] = 1;
            try {
                results[i] = residuals_of(effect_.apply(problem_.setting, values(places[i])),
                                          effect_.changes_deployment, problem_);
            } catch (const Error& error) {
                failures[i] = error.what();
            }
        });
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!is_new[i]) continue;
            num_runs_ += effect_.changes_deployment ? 1 : 0;
            if (results[i].size() > 0) {
                known_.emplace(values(places[i]), results[i]);
            } else {
                failure_ = failures[i];
            }
        }
        return results;
    }

    /// Whitened residuals and their derivatives by the scaled parameters, from one side, towards
    /// the inside of the bounds. None where the effect cannot be simulated.
    std::optional<std::pair<Eigen::VectorXd, Eigen::MatrixXd>> with_derivatives(
        const Eigen::VectorXd& x)
    {
        std::vector<Eigen::VectorXd> places = {x};
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const double step = parameters_[index(i)].step / parameters_[index(i)].prior_sd;
            Eigen::VectorXd moved = x;
            moved[i] += x[i] + step > upper(i) ? -step : step;
            places.push_back(moved);
        }
        const std::vector<Eigen::VectorXd> results = at(places);
        if (results.front().size() == 0) return std::nullopt;
        const Eigen::VectorXd here = problem_.whitening(results.front());
        Eigen::MatrixXd derivatives(here.size(), x.size());
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const Eigen::VectorXd& there = results[index(i) + 1];
            if (there.size() == 0) return std::nullopt;
            derivatives.col(i) =
                (problem_.whitening(there) - here) / (places[index(i) + 1][i] - x[i]);
        }
        return std::pair{here, derivatives};
    }

    std::optional<Eigen::VectorXd> whitened(const Eigen::VectorXd& x)
    {
        const Eigen::VectorXd result = at({x}).front();
        if (result.size() == 0) return std::nullopt;
        return problem_.whitening(result);
    }

    int num_runs() const { return num_runs_; }
    const std::string& failure() const { return failure_; }

private:
    const Effect& effect_;
    const FitProblem& problem_;
    std::vector<EffectParameter> parameters_;
    std::map<std::vector<double>, Eigen::VectorXd> known_;
    int num_runs_ = 0;
    std::string failure_;
};

/// Whitened residuals, then x for each parameter with a normal prior.
class PosteriorRows : public ceres::CostFunction {
public:
    PosteriorRows(EffectResiduals& residuals, Eigen::Index num_data)
        : residuals_(residuals), num_data_(num_data)
    {
        set_num_residuals(static_cast<int>(num_data + residuals.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(residuals.size()));
    }

    bool Evaluate(double const* const* parameters, double* rows, double** jacobians) const override
    {
        const Eigen::Index n = residuals_.size();
        const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], n);
        Eigen::Map<Eigen::VectorXd> row(rows, num_data_ + n);
        const bool wants_slope = jacobians != nullptr && jacobians[0] != nullptr;
        Eigen::VectorXd weight(n);
        for (Eigen::Index i = 0; i < n; ++i)
            weight[i] = residuals_.parameters()[index(i)].is_uniform ? 0.0 : 1.0;
        if (!wants_slope) {
            const auto z = residuals_.whitened(x);
            if (!z) return false;
            row << *z, weight.cwiseProduct(x);
            return true;
        }
        const auto found = residuals_.with_derivatives(x);
        if (!found) return false;
        row << found->first, weight.cwiseProduct(x);
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> slope(
            jacobians[0], num_data_ + n, n);
        slope.topRows(num_data_) = found->second;
        slope.bottomRows(n) = weight.asDiagonal();
        return true;
    }

private:
    EffectResiduals& residuals_;
    Eigen::Index num_data_;
};

/// A start that takes less off the misfit is not worth a fit.
constexpr double least_reduction = 2.0;

/// True if two starts differ in more than the amplitude.
bool lie_apart(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    return (a - b).tail(a.size() - 1).norm() > 0.0;
}

/// The starts that leave the smallest misfit, best first; none if no start helps.
std::vector<Eigen::VectorXd> best_starts(EffectResiduals& residuals, const Effect& effect,
                                         const FitProblem& problem, const FitOptions& options)
{
    std::vector<Eigen::VectorXd> starts;
    for (const auto& values : effect.starts(problem.setting))
        starts.push_back(residuals.scaled(values));
    if (starts.size() == 1) return starts;
    const double base = problem.whitening(problem.base_residuals).squaredNorm();
    const std::vector<Eigen::VectorXd> simulated = residuals.at(starts);
    std::vector<std::pair<double, std::size_t>> misfits;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (simulated[i].size() > 0)
            misfits.emplace_back(problem.whitening(simulated[i]).squaredNorm(), i);
    }
    std::stable_sort(misfits.begin(), misfits.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Eigen::VectorXd> best;
    for (const auto& [misfit, i] : misfits) {
        if (base - misfit < least_reduction || static_cast<int>(best.size()) == options.num_starts)
            break;
        const Eigen::VectorXd& start = starts[i];
        if (std::all_of(best.begin(), best.end(),
                        [&](const Eigen::VectorXd& other) { return lie_apart(start, other); })) {
            best.push_back(start);
        }
    }
    return best;
}

/// The parameters after Levenberg and Marquardt's steps from a start.
Eigen::VectorXd minimised(EffectResiduals& residuals, Eigen::Index num_data, Eigen::VectorXd x,
                          const FitOptions& options)
{
    if (!residuals.with_derivatives(x)) return x;  // Ceres would complain on stderr
    ceres::Problem problem;
    // Bounds are kept by `EffectResiduals::values`; Ceres' own take a line search at each step.
    problem.AddResidualBlock(new PosteriorRows(residuals, num_data), nullptr, x.data());
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.logging_type = ceres::SILENT;
    solver.max_num_iterations = options.max_iterations;
    solver.num_threads = 1;
    // A change of the log posterior by less than about 0.1 decides nothing.
    solver.function_tolerance = 1e-3;
    solver.parameter_tolerance = 1e-3;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    return residuals.scaled(residuals.values(x));
}

/// The fit at parameters; none if the effect cannot be simulated there.
std::optional<EffectFit> fit_at(EffectResiduals& residuals, const Effect& effect,
                                const FitProblem& problem, const Eigen::VectorXd& x)
{
    const auto found = residuals.with_derivatives(x);
    if (!found) return std::nullopt;
    const auto& [z, derivatives] = *found;
    EffectFit fit;
    fit.effect = effect.name;
    fit.parameters = residuals.parameters();
    fit.values = residuals.values(x);
    fit.residuals = residuals.at({x}).front();
    fit.chi_square = z.squaredNorm();
    std::vector<bool> is_uniform;
    for (const EffectParameter& parameter : fit.parameters)
        is_uniform.push_back(parameter.is_uniform);
    fit.log_evidence =
        log_bayes_factor(problem.whitening(problem.base_residuals), z, derivatives, x, is_uniform);
    const Eigen::Index n = x.size();
    const Eigen::MatrixXd covariance =
        (Eigen::MatrixXd::Identity(n, n) + derivatives.transpose() * derivatives).inverse();
    for (Eigen::Index i = 0; i < n; ++i)
        fit.sd.push_back(std::sqrt(covariance(i, i)) * fit.parameters[index(i)].prior_sd);
    return fit;
}

/// The first start that can be simulated, with an amplitude of zero, which is no effect.
Eigen::VectorXd without_amplitude(EffectResiduals& residuals, const Effect& effect,
                                  const FitProblem& problem)
{
    const auto starts = effect.starts(problem.setting);
    std::vector<double> values = starts.front();
    for (const auto& start : starts) {
        if (residuals.at({residuals.scaled(start)}).front().size() == 0) continue;
        values = start;
        break;
    }
    values.front() = 0.0;
    return residuals.scaled(values);
}

}  // namespace

Eigen::VectorXd residuals_of(const Model& model, bool changes_deployment, const FitProblem& problem)
{
    if (!changes_deployment) return residuals(problem.observations, problem.base, model.imaging);
    return residuals(problem.observations, simulate(model, problem.lumen), model.imaging);
}

EffectFit fit_effect(const Effect& effect, const FitProblem& problem, const FitOptions& options)
{
    EffectResiduals residuals(effect, problem);
    std::vector<Eigen::VectorXd> ends;
    for (const Eigen::VectorXd& start : best_starts(residuals, effect, problem, options))
        ends.push_back(minimised(residuals, problem.base_residuals.size(), start, options));
    if (ends.empty()) ends.push_back(without_amplitude(residuals, effect, problem));
    std::optional<EffectFit> best;
    std::vector<FitMode> modes;
    for (const Eigen::VectorXd& x : ends) {
        const auto fit = fit_at(residuals, effect, problem, x);
        if (!fit) continue;
        modes.push_back({fit->values, fit->log_evidence});
        if (!best || fit->log_evidence > best->log_evidence) best = fit;
    }
    if (!best) {
        best.emplace();
        best->effect = effect.name;
        best->parameters = residuals.parameters();
        best->log_evidence = -std::numeric_limits<double>::infinity();
        best->failure = residuals.failure();
    }
    best->modes = modes;
    best->num_runs = residuals.num_runs();
    return *best;
}

}  // namespace braidzone
