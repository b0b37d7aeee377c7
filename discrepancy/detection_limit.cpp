#include "discrepancy/detection_limit.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

constexpr double quantile_80 = 0.8416;
/// A smaller change of the whitened residuals, over a prior's standard deviation, is no trace.
constexpr double smallest_trace = 1e-3;

double limit_of(double per_unit, double prior_sd, double bar)
{
    const double spread = prior_sd * per_unit;
    return (quantile_80 + std::sqrt(2.0 * bar + std::log1p(spread * spread))) / per_unit;
}

}  // namespace

std::optional<DetectionLimit> detection_limit(const EffectFit& single, const Eigen::VectorXd& base,
                                              const Candidate& candidate,
                                              const Whitening& whitening, double bar)
{
    if (!single.failure.empty()) return std::nullopt;
    const EffectParameter& first = candidate.parameters.front();
    double largest = 0.0;  // change per unit of amplitude
    std::vector<double> at = candidate.starts.front();
    if (candidate.starts.size() == 1) {
        largest = whitening(single.derivatives.col(0)).norm() / first.prior_sd;
    } else {
        for (const Trial& trial : single.trials) {
            const bool is_start = std::find(candidate.starts.begin(), candidate.starts.end(),
                                            trial.values) != candidate.starts.end();
            const double amplitude = std::abs(trial.values.front() - first.prior_mean);
            if (!is_start || !(amplitude > 0.0)) continue;
            const double change = whitening(base - trial.residuals).norm() / amplitude;
            if (change <= largest) continue;
            largest = change;
            at = trial.values;
        }
    }
    if (largest * first.prior_sd < smallest_trace) return std::nullopt;
    DetectionLimit limit{.amplitude = limit_of(largest, first.prior_sd, bar), .at = at};
    limit.at.front() = first.prior_mean + std::copysign(limit.amplitude, at.front());
    return limit;
}

}  // namespace braidzone
