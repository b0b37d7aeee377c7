#pragma once

#include "discrepancy/effect.hpp"

namespace braidzone {

// A stretch of changed ring spacing, which a push and a pull share.

/// Relative change of the ring spacing, centre and half-width of the stretch.
/// @param mean, sd, lower, upper  of the change of the spacing
std::vector<EffectParameter> window_parameters(const EffectSetting& setting, double sd,
                                               double lower, double upper);

/// Starts every 2.5 mm along the device, at each of some changes of spacing.
std::vector<std::vector<double>> window_starts(const EffectSetting& setting,
                                               const std::vector<double>& changes);

/// The base model with the stretch, cut off at the device's distal end.
/// @throws ConfigError if the schedule holds a stretch there already, or is a table
Model with_window(const EffectSetting& setting, const std::vector<double>& parameters);

}  // namespace braidzone
