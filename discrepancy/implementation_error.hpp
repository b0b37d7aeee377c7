#pragma once

#include "discrepancy/diagnosis_problem.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// Covariance that allows for a wrong shape of an effect that is in the model:
///
///     C + (rho |m|)^2, correlated as exp(-distance / correlation_length)
///
/// with m what the effects change in the field; in the single numbers, correlated as
/// `DiagnosisProblem::shape_correlation` says. Without it the imperfect shape of one effect is
/// taken for a second one (in a prototype 9 to 18 % of single effects; 4 to 9 % with rho = 0.2).
/// What the effects do at random (`roughness_variance`) is added to C.
/// @param effects  that are in the model
/// @param change  of the residuals, by the effects
/// @param ratio   rho; >= 0
Eigen::MatrixXd with_implementation_error(const DiagnosisProblem& problem,
                                          const std::vector<ActiveEffect>& effects,
                                          const Eigen::VectorXd& change, double ratio);

}  // namespace braidzone
