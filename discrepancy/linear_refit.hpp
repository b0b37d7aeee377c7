#pragma once

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// A fit with normal errors and priors, taken as linear in its parameters about a point.
struct LinearRefit {
    Eigen::VectorXd x;         ///< parameters in units of their priors
    Eigen::VectorXd whitened;  ///< residuals there
    /// -1/2 (|z|^2 + |x|^2) - 1/2 ln det(I + S' S) + 1/2 ln(2 pi / 12) per uniform parameter: the
    /// log evidence but for a constant of the data, see `log_bayes_factor`.
    double log_evidence = 0.0;
};

/// Minimises |z + S (y - x)|^2 + the sum of y^2 over parameters with a normal prior.
/// @param whitened     z at x
/// @param derivatives  S of the whitened residuals by the parameters
LinearRefit linear_refit(const Eigen::VectorXd& whitened, const Eigen::MatrixXd& derivatives,
                         const Eigen::VectorXd& x, const std::vector<bool>& is_uniform);

}  // namespace braidzone
