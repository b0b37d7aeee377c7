#include "discrepancy/background_estimate.hpp"

#include "discrepancy/whitening.hpp"

#include <cmath>

namespace braidzone {

double background_scale(const ErrorModel& error, const Eigen::VectorXd& residuals)
{
    const Eigen::Index n = error.num_patches;
    const double prior_sd = std::log(1.6);
    double best = 1.0, highest = -1e300;
    for (double log_scale = -1.2; log_scale <= 1.5; log_scale += 0.05) {
        const double scale = std::exp(log_scale);
        Eigen::MatrixXd covariance = error.covariance();
        covariance.topLeftCorner(n, n) +=
            (scale * scale - 1.0) * error.background.topLeftCorner(n, n);
        const Whitening whitening(covariance);
        const double u = log_scale / prior_sd;
        const double log_posterior = -0.5 * whitening(residuals).squaredNorm() -
                                     0.5 * whitening.log_determinant() - 0.5 * u * u;
        if (log_posterior <= highest) continue;
        highest = log_posterior;
        best = scale;
    }
    return best;
}

}  // namespace braidzone
