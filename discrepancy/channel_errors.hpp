#pragma once

#include "discrepancy/error_model.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// Puts the errors of density and contact force into the error model, blocks of their own:
///
///     C = diag(sd^2) + density_sd^2 q q' exp(-distance / background_length)
///                    + density_scale_sd^2 q q'                                densities
///     C = sd^2 + (force_sd F)^2                                               force
///
/// with q the densities of the case as it is (`DensityField::scale`) and F the measured force. The
/// scale common to all densities, of the picture's threshold and length, is marginalised. Errors of
/// the device's length, of which its density depends too, are taken as independent: 0.15 mm of
/// 17 mm are 1 % of density, far below the common scale.
/// @param error  with rows for all residuals of the observations
void add_channel_errors(ErrorModel& error, const Observations& observations,
                        const NoiseFloor& floor);

/// What may be off for unknown reasons in the single numbers, one matrix a channel that was
/// measured, as `DiagnosisProblem::unknown_channels`: each length by 1 mm, the densities by 10 %
/// over 2 mm, the force by 20 %.
std::vector<Eigen::MatrixXd> unknown_channels(const Observations& observations);

/// Correlation of an effect's wrong shape among the single numbers
/// (`DiagnosisProblem::shape_correlation`): of densities exp(-distance / length), of the force with
/// itself; none of the lengths, which tell the size of an effect and not its shape.
Eigen::MatrixXd shape_correlation(const Observations& observations, double length);

}  // namespace braidzone
