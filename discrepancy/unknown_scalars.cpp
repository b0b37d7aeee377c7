#include "discrepancy/unknown_scalars.hpp"

#include "discrepancy/laplace_evidence.hpp"
#include "discrepancy/whitening.hpp"

#include <vector>

namespace braidzone {
namespace {

double log_density(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& residuals)
{
    const Whitening whitening(covariance);
    return -0.5 * whitening(residuals).squaredNorm() - 0.5 * whitening.log_determinant();
}

}  // namespace

double unknown_scalars_evidence(const DiagnosisProblem& problem, const Eigen::VectorXd& residuals)
{
    const Eigen::Index count = residuals.size() - problem.distances.rows();
    if (count == 0 || problem.unknown_channels.empty()) return 0.0;
    const Eigen::MatrixXd noise = problem.covariance.bottomRightCorner(count, count);
    const Eigen::VectorXd scalars = residuals.tail(count);
    const double none = log_density(noise, scalars);
    std::vector<double> logs;
    for (const Eigen::MatrixXd& channel : problem.unknown_channels) {
        for (const double deviation : problem.unknown_deviations)
            logs.push_back(log_density(noise + deviation * deviation * channel, scalars) - none);
    }
    return log_of_mean(logs);
}

}  // namespace braidzone
