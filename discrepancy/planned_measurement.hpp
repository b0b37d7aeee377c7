#pragma once

#include "discrepancy/observations.hpp"

namespace braidzone {

/// What a measurement is expected to be like, before there is one.
struct PlannedMeasurement {
    double point_sd = 0.07e-3;  ///< noise of a point, of a C-arm scan [m]
    int points_per_patch = 12;  ///< on average; 2500 points of a device of 4 x 20 mm
    double end_sd = 0.3e-3;     ///< of each end marker's place [m]
};

/// A measurement of the case as it is, of the whole device and without noise: points on its
/// mid-surface at even distances, and both ends where they are. Its patches have the noise that is
/// planned, for the error model.
/// @param imaging  of the case: the points are those that its scan would show
Observations planned_observations(const Simulation& base, const Imaging& imaging,
                                  const PlannedMeasurement& plan = {},
                                  const PatchOptions& options = {});

}  // namespace braidzone
