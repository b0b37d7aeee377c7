#include "discrepancy/effect_roughness.hpp"

#include "core/error.hpp"
#include "discrepancy/laplace_evidence.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace braidzone {
namespace {

/// Places between the bounds at which the posterior is computed: a fiftieth of a prior of which
/// three standard deviations lie within the bounds.
constexpr int num_places = 161;

/// How rough an effect is differs from one device to the next: factors on its standard deviation,
/// the middle one twice as probable.
constexpr std::array<double, 4> factors = {0.6, 1.0, 1.0, 1.6};

Whitening whitening_with(const DiagnosisProblem& problem, const std::vector<ActiveEffect>& effects,
                         double factor = 1.0)
{
    Eigen::MatrixXd covariance = problem.covariance;
    covariance.diagonal() += factor * factor * roughness_variance(problem, effects);
    return Whitening(covariance);
}

double log_density(const Whitening& whitening, const Eigen::VectorXd& residuals)
{
    return -0.5 * (whitening(residuals).squaredNorm() + whitening.log_determinant());
}

/// The posterior on the grid: places in units of the prior, and their weights, of sum 1.
struct Posterior {
    Eigen::VectorXd places;
    Eigen::VectorXd weights;
    double log_evidence = 0.0;

    double mean() const { return weights.dot(places); }
    double sd() const
    {
        return std::sqrt(weights.dot((places.array() - mean()).square().matrix()));
    }
};

Posterior posterior_of(const DiagnosisProblem& problem, EffectResiduals& residuals, double none)
{
    const EffectParameter& parameter = residuals.parameters().front();
    Posterior posterior;
    posterior.places =
        Eigen::VectorXd::LinSpaced(num_places, (parameter.lower - parameter.prior_mean),
                                   (parameter.upper - parameter.prior_mean)) /
        parameter.prior_sd;
    std::vector<double> log_priors, logs;
    for (const double x : posterior.places) {
        const Eigen::VectorXd place = Eigen::VectorXd::Constant(1, x);
        const Eigen::VectorXd here = residuals.at({place}).front();
        if (here.size() == 0) return {};
        const auto effects = residuals.effects(residuals.values(place));
        std::vector<double> densities;
        for (const double factor : factors)
            densities.push_back(log_density(whitening_with(problem, effects, factor), here));
        log_priors.push_back(parameter.is_uniform ? 0.0 : -0.5 * x * x);
        logs.push_back(log_priors.back() + log_of_mean(densities) - none);
    }
    const double total = log_of_mean(logs);
    posterior.log_evidence = total - log_of_mean(log_priors);
    posterior.weights = (Eigen::Map<const Eigen::ArrayXd>(logs.data(), num_places) - total).exp() /
                        static_cast<double>(num_places);
    return posterior;
}

}  // namespace

Eigen::VectorXd roughness_variance(const DiagnosisProblem& problem,
                                   const std::vector<ActiveEffect>& effects)
{
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(problem.covariance.rows());
    for (const ActiveEffect& effect : effects) {
        const Candidate& candidate = problem.candidates[effect.candidate];
        if (!candidate.roughness) continue;
        variance.head(problem.distances.rows()) +=
            candidate.roughness(effect.values).array().square().matrix();
    }
    return variance;
}

EffectFit fit_rough_effect(const DiagnosisProblem& problem, const Eigen::VectorXd& base,
                           std::size_t candidate)
{
    const Candidate& known = problem.candidates[candidate];
    if (known.parameters.size() != 1) {
        throw InputError(fmt::format("effect {} is rough and has {} parameters; allowed is one",
                                     known.name, known.parameters.size()));
    }
    EffectResiduals residuals(problem, {candidate});
    const Posterior posterior =
        posterior_of(problem, residuals, log_density(Whitening(problem.covariance), base));
    EffectFit fit;
    fit.effects = {
        {candidate, known.name, known.title, known.separated_by, known.parameters, {0.0}, {0.0}}};
    fit.num_runs = residuals.num_runs();
    fit.failure = residuals.failure();
    if (!fit.failure.empty()) {
        fit.log_evidence = -std::numeric_limits<double>::infinity();
        return fit;
    }
    fit.x = Eigen::VectorXd::Constant(1, posterior.mean());
    const auto found = residuals.with_derivatives(fit.x);
    std::tie(fit.residuals, fit.derivatives) = *found;
    fit.effects.front().values = residuals.values(fit.x);
    fit.effects.front().sd = {posterior.sd() * known.parameters.front().prior_sd *
                              known.interval_factor};
    fit.log_evidence = fit.log_evidence_together = posterior.log_evidence;
    fit.chi_square = whitening_with(problem, active_effects(fit))(fit.residuals).squaredNorm();
    fit.modes = {{fit.effects.front().values, fit.log_evidence}};
    fit.trials = residuals.trials();
    return fit;
}

}  // namespace braidzone
