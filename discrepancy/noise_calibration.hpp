#pragma once

#include "discrepancy/lumen.hpp"
#include "discrepancy/noise_floor.hpp"
#include "discrepancy/observations.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// A measurement in which no effect is missing, against its simulation.
struct CalibrationSet {
    Observations observations;
    Eigen::VectorXd residuals;  ///< [m]
};

/// The set of a scan, as a diagnosis would see it: in patches without those of something else
/// (`leave_out_artefacts`), with the slopes of the hubs.
/// @param base  simulation of the model
/// @throws what `simulate` throws
CalibrationSet calibration_set(std::vector<Vec3> points, const MeasuredScalars& scalars,
                               const Model& model, const Simulation& base, const Lumen& lumen);

/// Learns the noise floor: its constants maximise the probability of the sets' residuals, r ~
/// N(0, C), with a log-normal prior of factor 3 on each constant about the shipped value, which
/// decides where a few sets say nothing. The residuals have no mean to estimate, so that restricted
/// and plain maximum likelihood are the same; the registration is part of C.
///
/// One constant at a time by steps that shrink to 3 %, over and over.
///
/// @throws InputError if there are fewer than 3 sets
NoiseFloor calibrate_noise_floor(const std::vector<CalibrationSet>& sets);

/// Log probability density of a set's residuals, but for a constant.
double log_likelihood(const CalibrationSet& set, const NoiseFloor& floor);

}  // namespace braidzone
