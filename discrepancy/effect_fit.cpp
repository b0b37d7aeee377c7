#include "discrepancy/effect_fit.hpp"

#include "discrepancy/effect_roughness.hpp"
#include "discrepancy/fingerprint.hpp"
#include "discrepancy/laplace_evidence.hpp"

#include <Eigen/Dense>
#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace braidzone {
namespace {

/// A start whose fingerprint takes less off half the misfit is not worth a fit.
constexpr double least_gain = 2.5;
/// A start from which the linearised problem takes less off half the misfit is left where it is.
constexpr double least_promise = 1.0;

std::size_t index(Eigen::Index i)
{
    return static_cast<std::size_t>(i);
}

/// What a fit is made to.
struct FitData {
    const Whitening& whitening;
    const Eigen::VectorXd& base;
};

/// 1 for each parameter with a normal prior, else 0.
Eigen::VectorXd prior_weights(const EffectResiduals& residuals)
{
    Eigen::VectorXd weights(residuals.size());
    for (Eigen::Index i = 0; i < weights.size(); ++i)
        weights[i] = residuals.parameters()[index(i)].is_uniform ? 0.0 : 1.0;
    return weights;
}

/// Whitened residuals, then x for each parameter with a normal prior.
class PosteriorRows : public ceres::CostFunction {
public:
    PosteriorRows(EffectResiduals& residuals, const FitData& data)
        : residuals_(residuals), data_(data), weights_(prior_weights(residuals))
    {
        set_num_residuals(static_cast<int>(data.base.size() + residuals.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(residuals.size()));
    }

    bool Evaluate(double const* const* parameters, double* rows, double** jacobians) const override
    {
        const Eigen::Index n = residuals_.size(), num_data = data_.base.size();
        const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], n);
        Eigen::Map<Eigen::VectorXd> row(rows, num_data + n);
        if (jacobians == nullptr || jacobians[0] == nullptr) {
            const Eigen::VectorXd here = residuals_.at({x}).front();
            if (here.size() == 0) return false;
            row << data_.whitening(here), weights_.cwiseProduct(x);
            return true;
        }
        const auto found = residuals_.with_derivatives(x);
        if (!found) return false;
        row << data_.whitening(found->first), weights_.cwiseProduct(x);
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> slope(
            jacobians[0], num_data + n, n);
        slope.topRows(num_data) = data_.whitening.of_columns(found->second);
        slope.bottomRows(n) = weights_.asDiagonal();
        return true;
    }

private:
    EffectResiduals& residuals_;
    const FitData& data_;
    Eigen::VectorXd weights_;
};

/// True if two starts differ in more than the amplitude.
bool lie_apart(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
    return (a - b).tail(a.size() - 1).norm() > 0.0;
}

/// A start at the size at which its fingerprint fits best, if it leaves a smaller misfit than the
/// start as it is: one may be far stronger than what is there.
Eigen::VectorXd at_best_size(EffectResiduals& residuals, const FitData& data,
                             std::vector<double> values, double size)
{
    const Eigen::VectorXd start = residuals.scaled(values);
    values.front() *= size;
    const Eigen::VectorXd sized = residuals.scaled(values);
    const std::vector<Eigen::VectorXd> both = residuals.at({start, sized});
    if (both[1].size() == 0) return start;
    const auto misfit = [&](const Eigen::VectorXd& left) {
        return data.whitening(left).squaredNorm();
    };
    return misfit(both[1]) < misfit(both[0]) ? sized : start;
}

/// The starts whose fingerprints promise most, best first, at places of their own; none if no
/// start helps.
std::vector<Eigen::VectorXd> best_starts(EffectResiduals& residuals, const Candidate& candidate,
                                         const FitData& data, const FitOptions& options)
{
    std::vector<Eigen::VectorXd> starts;
    for (const auto& values : candidate.starts)
        starts.push_back(residuals.scaled(values));
    if (starts.size() == 1) return starts;
    const Eigen::VectorXd z = data.whitening(data.base);
    const std::vector<Eigen::VectorXd> simulated = residuals.at(starts);
    std::vector<std::pair<FingerprintGain, std::size_t>> promises;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (simulated[i].size() == 0) continue;
        promises.emplace_back(fingerprint_gain(data.whitening(data.base - simulated[i]), z), i);
    }
    std::stable_sort(promises.begin(), promises.end(),
                     [](const auto& a, const auto& b) { return a.first.gain > b.first.gain; });
    std::vector<Eigen::VectorXd> best;
    for (const auto& [promise, i] : promises) {
        if (promise.gain < least_gain || static_cast<int>(best.size()) == options.num_starts) break;
        const Eigen::VectorXd& start = starts[i];
        if (std::all_of(best.begin(), best.end(),
                        [&](const Eigen::VectorXd& other) { return lie_apart(start, other); })) {
            best.push_back(at_best_size(residuals, data, candidate.starts[i], promise.size));
        }
    }
    return best;
}

/// What the linearised problem takes off half the sum of squares.
double promise(const EffectResiduals& residuals, const FitData& data, const Eigen::VectorXd& x,
               const std::pair<Eigen::VectorXd, Eigen::MatrixXd>& found)
{
    const Eigen::VectorXd weights = prior_weights(residuals);
    const Eigen::MatrixXd slope = data.whitening.of_columns(found.second);
    const Eigen::VectorXd gradient =
        slope.transpose() * data.whitening(found.first) + weights.cwiseProduct(x);
    Eigen::MatrixXd curvature = slope.transpose() * slope;
    curvature.diagonal() += weights;
    return 0.5 * gradient.dot(curvature.completeOrthogonalDecomposition().solve(gradient));
}

/// The parameters after Levenberg and Marquardt's steps from a start.
Eigen::VectorXd minimised(EffectResiduals& residuals, const FitData& data, Eigen::VectorXd x,
                          const FitOptions& options)
{
    const auto found = residuals.with_derivatives(x);
    if (!found) return x;  // Ceres would complain on stderr
    if (promise(residuals, data, x, *found) < least_promise) return x;
    ceres::Problem problem;
    // Bounds are kept by `EffectResiduals::values`; Ceres' own take a line search at each step.
    problem.AddResidualBlock(new PosteriorRows(residuals, data), nullptr, x.data());
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

/// Shares all values out to the effects.
std::vector<FittedEffect> fitted_effects(const EffectResiduals& residuals,
                                         const DiagnosisProblem& problem,
                                         const std::vector<double>& values,
                                         const std::vector<double>& sd)
{
    std::vector<FittedEffect> fitted;
    const std::vector<ActiveEffect> errors = residuals.effects(sd);
    for (const ActiveEffect& effect : residuals.effects(values)) {
        const Candidate& candidate = problem.candidates[effect.candidate];
        std::vector<double> wider = errors[fitted.size()].values;
        for (double& error : wider)
            error *= candidate.interval_factor;
        fitted.push_back({effect.candidate, candidate.name, candidate.title, candidate.separated_by,
                          candidate.parameters, effect.values, wider});
    }
    return fitted;
}

/// Covariance of the parameters in units of their priors: that of the best fit's curvature, H^-1 =
/// (I + S' S)^-1; where the residuals' covariance C_1 at the fit is not the one C that they were
/// whitened with, H^-1 (I + S' L^-1 C_1 L^-T S) H^-1.
Eigen::MatrixXd spread(const DiagnosisProblem& problem, const Whitening& whitening,
                       const Eigen::VectorXd& residuals, const Eigen::MatrixXd& slope)
{
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(slope.cols(), slope.cols());
    const Eigen::MatrixXd inverse = (one + slope.transpose() * slope).inverse();
    if (!problem.covariance_at) return inverse;
    const Eigen::MatrixXd half = whitening.of_columns(problem.covariance_at(residuals));
    const Eigen::MatrixXd whole = whitening.of_columns(half.transpose());
    return inverse * (one + slope.transpose() * whole * slope) * inverse;
}

/// The fit at parameters; none if the effects cannot be simulated there.
std::optional<EffectFit> fit_at(EffectResiduals& residuals, const DiagnosisProblem& problem,
                                const FitData& data, const Eigen::VectorXd& x)
{
    const auto found = residuals.with_derivatives(x);
    if (!found) return std::nullopt;
    EffectFit fit;
    fit.x = x;
    std::tie(fit.residuals, fit.derivatives) = *found;
    const Eigen::VectorXd z = data.whitening(fit.residuals);
    const Eigen::MatrixXd slope = data.whitening.of_columns(fit.derivatives);
    fit.chi_square = z.squaredNorm();
    const Eigen::MatrixXd covariance = spread(problem, data.whitening, fit.residuals, slope);
    std::vector<double> sd;
    for (Eigen::Index i = 0; i < x.size(); ++i)
        sd.push_back(std::sqrt(covariance(i, i)) * residuals.parameters()[index(i)].prior_sd);
    fit.effects = fitted_effects(residuals, problem, residuals.values(x), sd);
    std::vector<bool> is_uniform;
    for (const EffectParameter& parameter : residuals.parameters())
        is_uniform.push_back(parameter.is_uniform);
    fit.log_evidence = fit.log_evidence_together =
        log_bayes_factor(data.whitening(data.base), z, slope, x, is_uniform);
    return fit;
}

/// The first start that can be simulated, with an amplitude of zero, which is no effect.
Eigen::VectorXd without_amplitude(EffectResiduals& residuals, const Candidate& candidate)
{
    std::vector<double> values = candidate.starts.front();
    for (const auto& start : candidate.starts) {
        if (residuals.at({residuals.scaled(start)}).front().size() == 0) continue;
        values = start;
        break;
    }
    values.front() = 0.0;
    return residuals.scaled(values);
}

/// The best of the fits that ended at some places.
EffectFit best_of(EffectResiduals& residuals, const DiagnosisProblem& problem, const FitData& data,
                  const std::vector<Eigen::VectorXd>& ends)
{
    std::optional<EffectFit> best;
    std::vector<FitMode> modes;
    for (const Eigen::VectorXd& x : ends) {
        const auto fit = fit_at(residuals, problem, data, x);
        if (!fit) continue;
        modes.push_back({residuals.values(x), fit->log_evidence});
        if (!best || fit->log_evidence > best->log_evidence) best = fit;
    }
    if (!best) {
        best.emplace();
        const std::vector<double> none(index(residuals.size()), 0.0);
        best->effects = fitted_effects(residuals, problem, none, none);
        best->log_evidence = -std::numeric_limits<double>::infinity();
        best->failure = residuals.failure();
    }
    best->modes = modes;
    best->trials = residuals.trials();
    best->num_runs = residuals.num_runs();
    return *best;
}

}  // namespace

std::string name_of(const EffectFit& fit)
{
    std::string name;
    for (const FittedEffect& effect : fit.effects)
        name += (name.empty() ? "" : " + ") + effect.name;
    return name;
}

std::vector<ActiveEffect> active_effects(const EffectFit& fit)
{
    std::vector<ActiveEffect> effects;
    for (const FittedEffect& effect : fit.effects)
        effects.push_back({effect.candidate, effect.values});
    return effects;
}

std::vector<EffectParameter> parameters_of(const EffectFit& fit)
{
    std::vector<EffectParameter> all;
    for (const FittedEffect& effect : fit.effects)
        all.insert(all.end(), effect.parameters.begin(), effect.parameters.end());
    return all;
}

EffectFit fit_effect(const DiagnosisProblem& problem, const Whitening& whitening,
                     const Eigen::VectorXd& base, std::size_t candidate, const FitOptions& options)
{
    if (problem.candidates[candidate].roughness) return fit_rough_effect(problem, base, candidate);
    const FitData data{whitening, base};
    EffectResiduals residuals(problem, {candidate});
    std::vector<Eigen::VectorXd> ends;
    for (const Eigen::VectorXd& start :
         best_starts(residuals, problem.candidates[candidate], data, options))
        ends.push_back(minimised(residuals, data, start, options));
    if (ends.empty()) ends.push_back(without_amplitude(residuals, problem.candidates[candidate]));
    return best_of(residuals, problem, data, ends);
}

EffectFit fit_together(const DiagnosisProblem& problem, const Whitening& whitening,
                       const Eigen::VectorXd& base, const std::vector<ActiveEffect>& start,
                       const FitOptions& options)
{
    const FitData data{whitening, base};
    std::vector<std::size_t> candidates;
    std::vector<double> values;
    for (const ActiveEffect& effect : start) {
        candidates.push_back(effect.candidate);
        values.insert(values.end(), effect.values.begin(), effect.values.end());
    }
    EffectResiduals residuals(problem, candidates);
    return best_of(residuals, problem, data,
                   {minimised(residuals, data, residuals.scaled(values), options)});
}

}  // namespace braidzone
