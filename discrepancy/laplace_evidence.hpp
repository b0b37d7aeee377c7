#pragma once

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// Laplace's approximation of the log Bayes factor of a fitted effect against no effect; exact if
/// the residuals are linear in the parameters and all priors are normal. See `fit_effect`.
///
/// @param base        whitened residuals z_0 without the effect
/// @param fitted      whitened residuals z at the best fit
/// @param derivatives S = dz/dx, |z| x |x|
/// @param x           parameters at the best fit: from their prior's mean, over its standard
///                    deviation
/// @param is_uniform  |x|: uniform priors, of standard deviation 1 in x
double log_bayes_factor(const Eigen::VectorXd& base, const Eigen::VectorXd& fitted,
                        const Eigen::MatrixXd& derivatives, const Eigen::VectorXd& x,
                        const std::vector<bool>& is_uniform);

/// ln of the mean of exp(x) over some x, without overflow: evidence averaged over alternatives
/// that are alike probable.
/// @param logs  at least one
double log_of_mean(const std::vector<double>& logs);

}  // namespace braidzone
