#include "discrepancy/laplace_evidence.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

double log_bayes_factor(const Eigen::VectorXd& base, const Eigen::VectorXd& fitted,
                        const Eigen::MatrixXd& derivatives, const Eigen::VectorXd& x,
                        const std::vector<bool>& is_uniform)
{
    const Eigen::Index n = x.size();
    const Eigen::MatrixXd curvature =
        Eigen::MatrixXd::Identity(n, n) + derivatives.transpose() * derivatives;
    const Eigen::LLT<Eigen::MatrixXd> factor(curvature);
    const double half_log_determinant = factor.matrixLLT().diagonal().array().log().sum();
    double result = 0.5 * (base.squaredNorm() - fitted.squaredNorm()) - half_log_determinant;
    for (Eigen::Index i = 0; i < n; ++i) {
        result += is_uniform[static_cast<std::size_t>(i)]
                      ? 0.5 * std::log(2.0 * std::numbers::pi / 12.0)
                      : -0.5 * x[i] * x[i];
    }
    return result;
}

double log_of_mean(const std::vector<double>& logs)
{
    const double largest = *std::max_element(logs.begin(), logs.end());
    double sum = 0.0;
    for (const double value : logs)
        sum += std::exp(value - largest);
    return largest + std::log(sum / static_cast<double>(logs.size()));
}

}  // namespace braidzone
