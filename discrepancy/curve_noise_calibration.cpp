#include "discrepancy/curve_noise_calibration.hpp"

#include "core/error.hpp"
#include "discrepancy/constant_search.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace braidzone {
namespace {

constexpr std::size_t fewest_sets = 3;
constexpr double prior_factor = 3.0;

constexpr std::array<double CurveNoise::*, 7> constants = {
    &CurveNoise::point_sd,   &CurveNoise::absolute_sd,   &CurveNoise::scale_sd,
    &CurveNoise::zero_sd,    &CurveNoise::background_sd, &CurveNoise::background_length,
    &CurveNoise::abscissa_sd};

double log_posterior(const std::vector<CurveCalibrationSet>& sets, const CurveNoise& noise,
                     const CurveNoise& shipped)
{
    double sum = 0.0;
    for (const CurveCalibrationSet& set : sets) {
        const CurveWeights weights = make_curve_weights(set.measured.abscissae, set.simulated,
                                                        set.measured.standard_error, noise);
        sum += log_likelihood(weights, relative_residuals(set.measured, set.simulated, weights));
    }
    for (const auto constant : constants) {
        if (!(shipped.*constant > 0.0)) continue;
        const double u = std::log(noise.*constant / (shipped.*constant)) / std::log(prior_factor);
        sum -= 0.5 * u * u;
    }
    return sum;
}

}  // namespace

CurveNoise calibrate_curve_noise(const std::vector<CurveCalibrationSet>& sets,
                                 const CurveNoise& shipped)
{
    if (sets.size() < fewest_sets) {
        throw InputError(
            fmt::format("a noise floor is learned from at least {} curves without an effect; {} "
                        "given",
                        fewest_sets, sets.size()));
    }
    CurveNoise noise = best_constants(shipped, constants, [&](const CurveNoise& trial) {
        return log_posterior(sets, trial, shipped);
    });
    noise.source = fmt::format("learned from {} curves without an effect", sets.size());
    return noise;
}

}  // namespace braidzone
