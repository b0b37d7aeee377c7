#include "discrepancy/curve_noise.hpp"

#include "core/error.hpp"
#include "discrepancy/whitening.hpp"

#include <algorithm>

namespace braidzone {
namespace {

constexpr double weight_floor = 0.05;

/// A background of no length is one of each point.
constexpr double smallest_length = 1e-6;

}  // namespace

CurveNoise force_noise()
{
    return {.point_sd = 0.015,
            .absolute_sd = 0.0,
            .scale_sd = 0.02,
            .zero_sd = 0.0,
            .background_sd = 0.03,
            .background_length = 0.15};
}

CurveNoise pressure_noise()
{
    return {.point_sd = 0.005,
            .absolute_sd = 0.1,
            .scale_sd = 0.02,
            .zero_sd = 0.1,
            .background_sd = 0.01,
            .background_length = 0.5};
}

CurveWeights make_curve_weights(const std::vector<double>& abscissae,
                                const std::vector<double>& simulated, double standard_error,
                                const CurveNoise& noise)
{
    const auto n = static_cast<Eigen::Index>(abscissae.size());
    const Eigen::ArrayXd x = Eigen::Map<const Eigen::ArrayXd>(abscissae.data(), n);
    const Eigen::ArrayXd y = Eigen::Map<const Eigen::ArrayXd>(simulated.data(), n);
    const double largest = y.abs().maxCoeff();
    if (!(largest > 0.0)) throw InputError("the simulated curve is zero everywhere");
    CurveWeights result;
    result.weights = y.abs() + weight_floor * largest;
    const Eigen::VectorXd relative = y / result.weights.array();
    const Eigen::VectorXd offset = result.weights.cwiseInverse();
    result.distances = (x.replicate(1, n) - x.transpose().replicate(n, 1)).abs();
    result.nuisance = noise.scale_sd * noise.scale_sd * relative * relative.transpose() +
                      noise.zero_sd * noise.zero_sd * offset * offset.transpose();
    const double length = noise.background_length * (x[n - 1] - x[0]);
    const Eigen::VectorXd size = noise.background_sd * relative;
    result.covariance =
        result.nuisance + (size * size.transpose())
                              .cwiseProduct((-result.distances.array() /
                                             std::max(length, smallest_length * (x[n - 1] - x[0])))
                                                .exp()
                                                .matrix());
    const Eigen::ArrayXd own =
        (noise.point_sd * y).square() + noise.absolute_sd * noise.absolute_sd;
    // A floor of a thousandth of the largest value: no reading has more digits.
    const double least = std::max(standard_error, 1e-3 * largest);
    result.covariance.diagonal().array() +=
        own.max(least * least) / result.weights.array().square();
    return result;
}

double log_likelihood(const CurveWeights& weights, const Eigen::VectorXd& residuals)
{
    const Whitening whitening(weights.covariance);
    return -0.5 * whitening(residuals).squaredNorm() - 0.5 * whitening.log_determinant();
}

}  // namespace braidzone
