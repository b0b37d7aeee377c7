#pragma once

#include "discrepancy/noise_floor.hpp"
#include "discrepancy/observations.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// Values that do not go with the others: one after the other that which lies furthest from what
/// the remaining ones predict of it, as long as it does so by more than `bar` standard deviations.
///
///     (y_i - E[y_i | others]) / sd[y_i | others] = (P y)_i / sqrt(P_ii),   P = K^-1
///
/// @param covariance  K of all values
/// @return indices, in the order in which they were left out
std::vector<int> outlying_values(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& values,
                                 double bar);

/// Leaves patches out in which the points are those of something else, a coil or a streak: patches
/// that lie off what their neighbours predict by more than 5 standard deviations. Neighbours
/// predict with the error model and, so that an effect is not taken for an artefact, any field
/// besides that is smooth over 1 mm (0.16 mm, a Gaussian process).
///
/// The gap of a patch does not move with some of its points, but where most of them belong to
/// something else one patch would outweigh all others: errors are taken as normal.
/// @param residuals  of the base model
/// @return the patches that were left out
std::vector<Patch> leave_out_artefacts(Observations& observations, const Eigen::VectorXd& residuals,
                                       const NoiseFloor& floor);

}  // namespace braidzone
