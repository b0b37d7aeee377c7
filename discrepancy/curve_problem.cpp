#include "discrepancy/curve_problem.hpp"

#include <algorithm>

namespace braidzone {
namespace {

/// An effect's shape is wrong over a good part of the curve at once.
constexpr double implementation_length = 0.3;

constexpr std::size_t num_blocks = 4;

}  // namespace

DiagnosisProblem curve_problem_of(const CurveWeights& weights)
{
    const double range = weights.distances.maxCoeff();
    DiagnosisProblem problem;
    problem.covariance = weights.covariance;
    problem.nuisance = weights.nuisance;
    problem.distances = weights.distances;
    problem.correlation_length = implementation_length * range;
    problem.unknown_amplitudes = {0.02, 0.04, 0.08, 0.16, 0.32};
    for (const double length : {0.06, 0.12, 0.25})
        problem.unknown_lengths.push_back(length * range);
    return problem;
}

Eigen::VectorXd relative_residuals(const MeasuredCurve& measured,
                                   const std::vector<double>& simulated,
                                   const CurveWeights& weights)
{
    const Eigen::Index n = weights.weights.size();
    return (Eigen::Map<const Eigen::VectorXd>(measured.ordinates.data(), n) -
            Eigen::Map<const Eigen::VectorXd>(simulated.data(), n))
        .cwiseQuotient(weights.weights);
}

Eigen::MatrixXd covariance_at_fit(const MeasuredCurve& measured, const CurveNoise& noise,
                                  const CurveWeights& weights, const Eigen::VectorXd& residuals)
{
    std::vector<double> simulated;
    for (std::size_t i = 0; i < measured.ordinates.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        simulated.push_back(measured.ordinates[i] - weights.weights[row] * residuals[row]);
    }
    const CurveWeights own =
        make_curve_weights(measured.abscissae, simulated, measured.standard_error, noise);
    const Eigen::VectorXd units = own.weights.cwiseQuotient(weights.weights);
    return units.asDiagonal() * own.covariance * units.asDiagonal();
}

ExplainOptions curve_options()
{
    ExplainOptions options;
    options.search.most_effects = 2;
    options.verdict.offers_unknown = true;
    return options;
}

std::vector<std::vector<int>> curve_folds(std::size_t num_points)
{
    const std::size_t count = std::min(num_blocks, num_points);
    std::vector<std::vector<int>> folds(count);
    for (std::size_t i = 0; i < num_points; ++i)
        folds[i * count / num_points].push_back(static_cast<int>(i));
    return folds;
}

}  // namespace braidzone
