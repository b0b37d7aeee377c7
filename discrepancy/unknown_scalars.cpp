#include "discrepancy/unknown_scalars.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

double log_density(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& residuals)
{
    const Whitening whitening(covariance);
    return -0.5 * whitening(residuals).squaredNorm() - 0.5 * whitening.log_determinant();
}

}  // namespace

double unknown_scalars_evidence(const ErrorModel& error, const Eigen::VectorXd& residuals)
{
    const Eigen::Index count = residuals.size() - error.num_patches;
    if (count == 0) return 0.0;
    const Eigen::MatrixXd noise = error.covariance().bottomRightCorner(count, count);
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(count, count);
    const Eigen::VectorXd scalars = residuals.tail(count);
    const double none = log_density(noise, scalars);
    const double small = log_density(noise + 1e-6 * one, scalars) - none;
    const double large = log_density(noise + 16e-6 * one, scalars) - none;
    const double largest = std::max(small, large);
    return largest + std::log(0.5 * (std::exp(small - largest) + std::exp(large - largest)));
}

}  // namespace braidzone
