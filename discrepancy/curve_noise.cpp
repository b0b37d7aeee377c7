#include "discrepancy/curve_noise.hpp"

#include "core/error.hpp"
#include "discrepancy/whitening.hpp"

#include <algorithm>

namespace braidzone {
namespace {

constexpr double weight_floor = 0.05;

/// A background of no length is one of each point.
constexpr double smallest_length = 1e-6;

/// Slope at each point, from the one before to the one after it.
Eigen::VectorXd slopes(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y)
{
    const Eigen::Index n = x.size();
    Eigen::VectorXd result(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0),
                           after = std::min(i + 1, n - 1);
        result[i] = (y[after] - y[before]) / (x[after] - x[before]);
    }
    return result;
}

}  // namespace

CurveNoise force_noise()
{
    return {.point_sd = 0.01,
            .absolute_sd = 0.0,
            .scale_sd = 0.02,
            .zero_sd = 0.0,
            .background_sd = 0.02,
            .background_length = 0.2,
            .abscissa_sd = 0.02e-3,
            .source = "shipped defaults: load cells as stated, simulated press tests"};
}

CurveNoise pressure_noise()
{
    return {.point_sd = 0.005,
            .absolute_sd = 0.1,
            .scale_sd = 0.02,
            .zero_sd = 0.1,
            .background_sd = 0.01,
            .background_length = 0.5,
            .source = "shipped defaults: gauges as stated, the law against wire-resolved flow"};
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
    result.relative = y / result.weights.array();
    const Eigen::VectorXd& relative = result.relative;
    const Eigen::VectorXd offset = result.weights.cwiseInverse();
    result.distances = (x.replicate(1, n) - x.transpose().replicate(n, 1)).abs();
    result.nuisance = noise.scale_sd * noise.scale_sd * relative * relative.transpose() +
                      noise.zero_sd * noise.zero_sd * offset * offset.transpose();
    const double length = noise.background_length * (x[n - 1] - x[0]);
    const Eigen::VectorXd size = noise.background_sd * relative;
    const Eigen::VectorXd along = noise.abscissa_sd * slopes(x, y).cwiseProduct(offset);
    result.covariance =
        result.nuisance + (size * size.transpose() + along * along.transpose())
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
