#pragma once

#include "discrepancy/diagnosis_problem.hpp"

#include <Eigen/Core>

namespace braidzone {

/// Log Bayes factor of the single numbers being off by something unknown, against noise:
/// normal deviations K of one channel of them (`unknown_channels`), each number in its own unit;
/// the evidence averaged over the channels and `unknown_deviations` b.
///
///     ln B = ln N(r; 0, C + b^2 K) - ln N(r; 0, C)
///
/// Keeps "nothing is missing" from being said of a device that ends elsewhere, where its surface
/// agrees. It is no rival of a named effect: it would explain any two numbers.
/// @param residuals  of all data, the field first
/// @return 0 if there are no single numbers, or none may be off
double unknown_scalars_evidence(const DiagnosisProblem& problem, const Eigen::VectorXd& residuals);

}  // namespace braidzone
