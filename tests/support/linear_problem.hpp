#pragma once

#include "discrepancy/diagnosis_problem.hpp"

#include <Eigen/Core>

#include <cmath>
#include <random>

namespace braidzone::test {

/// A measurement along a line whose candidates change it in proportion to one parameter each, so
/// that everything about it is known in closed form: residuals r = data - sum of a_k F_k, noise of
/// standard deviation 1, priors a_k ~ N(0, 10^2).
struct LinearProblem {
    Eigen::MatrixXd fingerprints;  ///< F, one a column
    Eigen::VectorXd data;

    DiagnosisProblem problem() const
    {
        DiagnosisProblem problem;
        for (Eigen::Index k = 0; k < fingerprints.cols(); ++k) {
            const std::string name(1, static_cast<char>('a' + k));
            problem.candidates.push_back(
                {.name = name,
                 .title = "effect " + name,
                 .parameters = {normal_parameter("size", "1", 0.0, 10.0, -1000.0, 1000.0)},
                 .starts = {{0.0}},
                 .needs_simulation = true,
                 .separated_by = "a second look"});
        }
        problem.residuals = [*this](const std::vector<ActiveEffect>& effects) {
            Eigen::VectorXd residuals = data;
            for (const ActiveEffect& effect : effects) {
                residuals -= effect.values.front() *
                             fingerprints.col(static_cast<Eigen::Index>(effect.candidate));
            }
            return residuals;
        };
        const Eigen::Index n = data.size();
        problem.covariance = Eigen::MatrixXd::Identity(n, n);
        problem.distances = Eigen::MatrixXd::NullaryExpr(n, n, [](Eigen::Index i, Eigen::Index j) {
            return std::abs(static_cast<double>(i - j));
        });
        problem.correlation_length = 3.0;
        problem.unknown_amplitudes = {0.5, 2.0};
        problem.unknown_lengths = {2.0, 5.0};
        return problem;
    }
};

/// A bump of height 1 about a place.
inline Eigen::VectorXd bump(Eigen::Index size, double place, double width)
{
    return Eigen::VectorXd::NullaryExpr(size, [=](Eigen::Index i) {
        const double u = (static_cast<double>(i) - place) / width;
        return std::exp(-0.5 * u * u);
    });
}

inline Eigen::VectorXd white_noise(Eigen::Index size, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    return Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
}

/// Sixty places, three effects with bumps about 10, 30 and 50, and what is hidden of each.
inline LinearProblem three_bumps(double a, double b, double c, std::uint32_t seed)
{
    constexpr Eigen::Index size = 60;
    LinearProblem linear;
    linear.fingerprints.resize(size, 3);
    linear.fingerprints << bump(size, 10.0, 4.0), bump(size, 30.0, 4.0), bump(size, 50.0, 4.0);
    linear.data = linear.fingerprints * Eigen::Vector3d(a, b, c) + white_noise(size, seed);
    return linear;
}

}  // namespace braidzone::test
