#pragma once

#include "discrepancy/error_model.hpp"

#include <Eigen/Core>

namespace braidzone {

/// Log Bayes factor of the measured scalars being off by something unknown, against noise:
/// independent normal deviations of 1 or 4 mm each, the evidence averaged over the two.
///
///     ln B = ln N(r; 0, C + b^2 I) - ln N(r; 0, C)
///
/// Keeps "nothing is missing" from being said of a device that ends elsewhere, where its surface
/// agrees. It is no rival of a named effect: it would explain any two numbers.
/// @param residuals  of all data, patches first [m]
/// @return 0 if no scalar was measured
double unknown_scalars_evidence(const ErrorModel& error, const Eigen::VectorXd& residuals);

}  // namespace braidzone
