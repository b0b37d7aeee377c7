#pragma once

#include "discrepancy/further_measurement.hpp"
#include "discrepancy/observations.hpp"

namespace braidzone {

/// What a measurement is expected to be like, before there is one.
struct PlannedMeasurement {
    double point_sd = 0.07e-3;  ///< noise of a point, of a C-arm scan [m]
    int points_per_patch = 12;  ///< on average; 2500 points of a device of 4 x 20 mm
    double end_sd = 0.3e-3;     ///< of each end marker's place: a voxel and a half of 0.2 mm [m]
    /// Of the length between the ends along the vessel, taken from a projection [m].
    double length_sd = 0.5e-3;
    /// Relative, of the pores counted in a square: 6 of the 43 of a 4 mm device of 48 wires [-].
    double density_sd = 0.15;
    double density_window = 1.5e-3;  ///< side of the squares, one beside the other [m]
    double force_sd = 0.15;          ///< relative, of the device's force on the wall [-]
};

/// A measurement of the case as it is, of the whole device and without noise: points on its
/// mid-surface at even distances, both ends where they are, the density in squares all over it, and
/// the force on the wall. All have the noise that is planned, for the error model.
/// @param imaging  of the case: the points are those that its scan would show
Observations planned_observations(const Simulation& base, const Imaging& imaging,
                                  const PlannedMeasurement& plan = {},
                                  const PatchOptions& options = {});

/// A measurement with everything added that was not measured, with the values that the case as it
/// is predicts and the noise that is planned: end markers, length, density map and contact force. A
/// device that does not touch the wall has no contact force.
Observations with_further_channels(const Observations& measured, const Simulation& base,
                                   const Imaging& imaging, const PlannedMeasurement& plan = {});

/// Rows of a measurement with further channels.
struct PlannedRows {
    std::vector<int> measured;             ///< of what had been measured, increasing
    std::vector<FurtherChannel> channels;  ///< what was added, cheapest first
};

/// @param measured  as given to `with_further_channels`
/// @param planned   as returned by it
PlannedRows planned_rows(const Observations& measured, const Observations& planned,
                         const PlannedMeasurement& plan = {});

}  // namespace braidzone
