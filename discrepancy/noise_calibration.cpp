#include "discrepancy/noise_calibration.hpp"

#include "core/error.hpp"
#include "discrepancy/artefacts.hpp"
#include "discrepancy/constant_search.hpp"
#include "discrepancy/error_model.hpp"
#include "discrepancy/hub_slopes.hpp"
#include "discrepancy/whitening.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <utility>

namespace braidzone {
namespace {

constexpr std::size_t fewest_sets = 3;
constexpr double prior_factor = 3.0;

constexpr std::array<double NoiseFloor::*, 9> constants = {
    &NoiseFloor::background_sd, &NoiseFloor::background_length, &NoiseFloor::offset_sd,
    &NoiseFloor::hub_sd,        &NoiseFloor::shift_sd,          &NoiseFloor::angle_sd,
    &NoiseFloor::white_scale,   &NoiseFloor::landing_sd,        &NoiseFloor::length_sd};

double log_posterior(const std::vector<CalibrationSet>& sets, const NoiseFloor& floor)
{
    std::vector<double> parts(sets.size());
    tbb::parallel_for(std::size_t{0}, sets.size(),
                      [&](std::size_t i) { parts[i] = log_likelihood(sets[i], floor); });
    double sum = 0.0;
    for (const double part : parts)
        sum += part;
    const NoiseFloor shipped;
    for (const auto constant : constants) {
        const double u = std::log(floor.*constant / (shipped.*constant)) / std::log(prior_factor);
        sum -= 0.5 * u * u;
    }
    return sum;
}

}  // namespace

CalibrationSet calibration_set(std::vector<Vec3> points, const MeasuredScalars& scalars,
                               const Model& model, const Simulation& base, const Lumen& lumen)
{
    DiscrepancyField field = make_discrepancy_field(points, model.imaging, base);
    Observations observations{std::move(points), std::move(field), scalars};
    const auto measured = [&] {
        return residuals(observations, base, model.imaging, base.surface);
    };
    leave_out_artefacts(observations, measured(), {});
    set_hub_slopes(observations, model, base, lumen);
    Eigen::VectorXd left = measured();
    return {std::move(observations), std::move(left)};
}

double log_likelihood(const CalibrationSet& set, const NoiseFloor& floor)
{
    const Whitening whitening(make_error_model(set.observations, floor).covariance());
    return -0.5 * whitening(set.residuals).squaredNorm() - 0.5 * whitening.log_determinant();
}

NoiseFloor calibrate_noise_floor(const std::vector<CalibrationSet>& sets)
{
    if (sets.size() < fewest_sets) {
        throw InputError(fmt::format(
            "a noise floor is learned from at least {} measurements without an effect; {} given",
            fewest_sets, sets.size()));
    }
    NoiseFloor floor = best_constants(NoiseFloor{}, constants, [&](const NoiseFloor& trial) {
        return log_posterior(sets, trial);
    });
    floor.source = fmt::format("learned from {} measurements without an effect", sets.size());
    return floor;
}

}  // namespace braidzone
