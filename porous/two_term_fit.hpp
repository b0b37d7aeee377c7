#pragma once

#include "porous/sheet_loss.hpp"

#include <functional>
#include <vector>

namespace braidzone {

/// Pressure drop at one velocity.
struct LossSample {
    double velocity = 0.0;       ///< [m/s]; > 0
    double pressure_drop = 0.0;  ///< [Pa]
};

/// The two-term law nearest to samples in the sense of least squares:
///
///     minimise  sum_i (dp_i - a v_i - b v_i^2)^2,   b >= 0
///
/// Where the best b would be negative it is 0, and a = sum(v dp) / sum(v^2). With a single velocity
/// only a can be told.
/// @throws InputError without samples, for a velocity that is not positive, or if a comes out
///         negative: the samples are no loss
SheetLoss two_term_fit(const std::vector<LossSample>& samples);

/// Largest relative difference of a two-term law from samples [-].
double two_term_error(const SheetLoss& loss, const std::vector<LossSample>& samples);

/// Samples of a pressure drop at 20 velocities, evenly from `highest_velocity` / 20 up to it.
std::vector<LossSample> sample_loss(const std::function<double(double)>& pressure_drop,
                                    double highest_velocity);

}  // namespace braidzone
