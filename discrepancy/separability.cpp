#include "discrepancy/separability.hpp"

#include "core/error.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace braidzone {
namespace {

/// Residuals of the chosen rows alone.
DiagnosisProblem of_rows(const DiagnosisProblem& problem, const std::vector<int>& rows)
{
    DiagnosisProblem chosen = problem;
    chosen.residuals = [problem,
                        rows](const std::vector<ActiveEffect>& effects) -> Eigen::VectorXd {
        return problem.residuals(effects)(rows);
    };
    chosen.covariance = problem.covariance(rows, rows);
    // Data without noise tell smooth changes apart; these two are of all rows.
    chosen.covariance_at = {};
    for (Candidate& candidate : chosen.candidates)
        candidate.roughness = {};
    return chosen;
}

/// Starts of a candidate, or one standard deviation of its first parameter's prior.
std::vector<std::vector<double>> typical_sizes(const Candidate& candidate)
{
    if (candidate.starts.size() > 1) return candidate.starts;
    std::vector<double> values = candidate.starts.front();
    const EffectParameter& first = candidate.parameters.front();
    const double size = first.prior_mean + first.prior_sd;
    values.front() = size <= first.upper ? size : first.prior_mean - first.prior_sd;
    return {values};
}

/// What a candidate of typical size leaves for the case as it is; empty if it cannot be simulated.
Eigen::VectorXd typical_residuals(const DiagnosisProblem& problem, std::size_t candidate,
                                  const Whitening& whitening, const Eigen::VectorXd& base)
{
    std::vector<std::pair<double, Eigen::VectorXd>> sizes;
    for (const std::vector<double>& values : typical_sizes(problem.candidates[candidate])) {
        try {
            const Eigen::VectorXd residuals = problem.residuals({{candidate, values}});
            sizes.emplace_back(whitening(base - residuals).norm(), residuals);
        } catch (const Error&) {
            continue;  // another of its starts may be possible
        }
    }
    if (sizes.empty()) return {};
    std::sort(sizes.begin(), sizes.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return sizes[sizes.size() / 2].second;
}

/// What is left of some data when a candidate is fitted to them.
double left_by(const DiagnosisProblem& problem, const Eigen::VectorXd& data, std::size_t candidate,
               const Whitening& whitening, const FitOptions& options)
{
    DiagnosisProblem hidden = problem;
    hidden.residuals = [&](const std::vector<ActiveEffect>& effects) -> Eigen::VectorXd {
        return problem.residuals(effects) - data;
    };
    const Eigen::VectorXd base = problem.residuals({}) - data;
    const EffectFit fit = fit_effect(hidden, whitening, base, candidate, options);
    return fit.failure.empty() ? std::sqrt(fit.chi_square)
                               : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Separability separability(const DiagnosisProblem& all, const std::vector<int>& rows,
                          const FitOptions& options)
{
    const DiagnosisProblem problem = of_rows(all, rows);
    const auto n = static_cast<Eigen::Index>(problem.candidates.size());
    const Whitening whitening(problem.covariance);
    const Eigen::VectorXd base = problem.residuals({});
    Separability result;
    result.detection = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
    result.separation = result.detection.replicate(1, n);
    std::vector<Eigen::VectorXd> data(problem.candidates.size());
    for (const Candidate& candidate : problem.candidates)
        result.names.push_back(candidate.name);
    tbb::parallel_for(std::size_t{0}, data.size(), [&](std::size_t i) {
        data[i] = typical_residuals(problem, i, whitening, base);
        if (data[i].size() == 0) return;
        const auto row = static_cast<Eigen::Index>(i);
        result.detection[row] = whitening(base - data[i]).norm();
    });
    tbb::parallel_for(std::size_t{0}, data.size() * data.size(), [&](std::size_t pair) {
        const std::size_t i = pair / data.size(), j = pair % data.size();
        if (data[i].size() == 0) return;
        result.separation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            i == j ? 0.0 : left_by(problem, data[i], j, whitening, options);
    });
    return result;
}

}  // namespace braidzone
