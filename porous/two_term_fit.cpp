#include "porous/two_term_fit.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

SheetLoss two_term_fit(const std::vector<LossSample>& samples)
{
    if (samples.empty()) throw InputError("no pressure drops to fit a v + b v^2 to");
    // Sums of powers of v, in units of the highest velocity so that they are of one size.
    double scale = 0.0;
    for (const LossSample& sample : samples) {
        if (!(sample.velocity > 0.0)) {
            throw InputError(fmt::format("velocity {:.6g} m/s of a pressure drop: must be positive",
                                         sample.velocity));
        }
        scale = std::max(scale, sample.velocity);
    }
    double v2 = 0.0, v3 = 0.0, v4 = 0.0, v1_dp = 0.0, v2_dp = 0.0;
    for (const LossSample& sample : samples) {
        const double v = sample.velocity / scale;
        v2 += v * v;
        v3 += v * v * v;
        v4 += v * v * v * v;
        v1_dp += v * sample.pressure_drop;
        v2_dp += v * v * sample.pressure_drop;
    }
    const double determinant = v2 * v4 - v3 * v3;
    // Of one velocity the determinant is 0 to round-off.
    constexpr double round_off = 1e-12;
    double a = v1_dp / v2, b = 0.0;
    if (determinant > round_off * v2 * v4) {
        const double best_b = (v2 * v2_dp - v3 * v1_dp) / determinant;
        if (best_b > 0.0) {
            b = best_b;
            a = (v4 * v1_dp - v3 * v2_dp) / determinant;
        }
    }
    if (!(a >= 0.0)) {
        throw InputError(fmt::format(
            "a v + b v^2 fitted to {} pressure drops up to {:.6g} m/s has a negative linear part "
            "a = {:.6g} Pa s/m; are they losses of a sheet, with velocities low enough?",
            samples.size(), scale, a / scale));
    }
    return {a / scale, b / (scale * scale)};
}

double two_term_error(const SheetLoss& loss, const std::vector<LossSample>& samples)
{
    double largest = 0.0;
    for (const LossSample& sample : samples) {
        const double fitted = pressure_drop(loss, sample.velocity);
        largest = std::max(largest, std::abs(fitted / sample.pressure_drop - 1.0));
    }
    return largest;
}

std::vector<LossSample> sample_loss(const std::function<double(double)>& pressure_drop,
                                    double highest_velocity)
{
    constexpr int num_velocities = 20;
    std::vector<LossSample> samples;
    for (int i = 1; i <= num_velocities; ++i) {
        const double velocity = highest_velocity * i / num_velocities;
        samples.push_back({velocity, pressure_drop(velocity)});
    }
    return samples;
}

}  // namespace braidzone
