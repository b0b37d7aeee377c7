#pragma once

#include "discrepancy/effect_fit.hpp"

#include <Eigen/Core>

#include <optional>

namespace braidzone {

/// The smallest amplitude of an effect that would have been seen.
struct DetectionLimit {
    double amplitude = 0.0;       ///< change of the effect's first parameter [SI]
    std::vector<double> at = {};  ///< the parameters where it is smallest, that amplitude first
};

/// Amplitude at which a measurement like this one shows an effect in 8 of 10 cases: its log
/// evidence, taken as linear in the amplitude, exceeds the bar.
///
///     a = (0.84 + sqrt(2 (bar + ln(1 + s^2 |f|^2) / 2))) / |f|
///
/// with f what a unit of amplitude changes of the whitened residuals and s the standard deviation
/// of its prior; 0.84 is the normal distribution's 80 % quantile. f is that of the simulated start
/// that shows most, or of the derivative where fits begin at no effect.
/// @param bar  of the log evidence
/// @return none if the effect could not be simulated or leaves no trace
std::optional<DetectionLimit> detection_limit(const EffectFit& single, const Eigen::VectorXd& base,
                                              const Candidate& candidate,
                                              const Whitening& whitening, double bar);

}  // namespace braidzone
