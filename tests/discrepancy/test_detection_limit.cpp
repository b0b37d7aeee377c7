#include "discrepancy/detection_limit.hpp"
#include "support/linear_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

constexpr double bar = 4.0;

std::optional<DetectionLimit> limit_of_b(const test::LinearProblem& linear)
{
    const DiagnosisProblem problem = linear.problem();
    const Whitening whitening(problem.covariance);
    return detection_limit(fit_effect(problem, whitening, linear.data, 1), linear.data,
                           problem.candidates[1], whitening, bar);
}

}  // namespace

// With a bump of that height hidden in noise, the evidence is beyond the bar in 80 % of 400
// measurements, give or take 3 standard deviations of 2 %.
TEST(DetectionLimit, IsSeenInEightOfTenMeasurements)
{
    const auto limit = limit_of_b(test::three_bumps(0.0, 0.0, 0.0, 1));
    ASSERT_TRUE(limit.has_value());
    int seen = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        const test::LinearProblem linear = test::three_bumps(0.0, limit->amplitude, 0.0, seed);
        const DiagnosisProblem problem = linear.problem();
        const EffectFit fit = fit_effect(problem, Whitening(problem.covariance), linear.data, 1);
        seen += fit.log_evidence > bar ? 1 : 0;
    }
    EXPECT_NEAR(seen / 400.0, 0.8, 0.06);
}

// Of several starts the one that shows most counts: b of twice the size beside one of its own.
TEST(DetectionLimit, IsThatOfTheStartThatShowsMost)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 2);
    DiagnosisProblem problem = linear.problem();
    problem.candidates[1].parameters.push_back(uniform_parameter("place", "1", 0.0, 1.0, 0.1));
    problem.candidates[1].starts = {{1.0, 0.0}, {1.0, 1.0}};
    problem.residuals = [linear](const std::vector<ActiveEffect>& effects) -> Eigen::VectorXd {
        if (effects.empty()) return linear.data;
        const std::vector<double>& x = effects.front().values;
        return linear.data - x[0] * (1.0 + x[1]) * linear.fingerprints.col(1);
    };
    const Whitening whitening(problem.covariance);
    const auto limit = detection_limit(fit_effect(problem, whitening, linear.data, 1), linear.data,
                                       problem.candidates[1], whitening, bar);
    ASSERT_TRUE(limit.has_value());
    const double per_unit = 2.0 * linear.fingerprints.col(1).norm();
    EXPECT_NEAR(
        limit->amplitude,
        (0.8416 + std::sqrt(2.0 * (bar + 0.5 * std::log(1.0 + 100.0 * per_unit * per_unit)))) /
            per_unit,
        1e-9);
    EXPECT_EQ(limit->at[1], 1.0);
}

TEST(DetectionLimit, IsNoneWithoutATrace)
{
    test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 3);
    linear.fingerprints.col(1).setZero();
    EXPECT_FALSE(limit_of_b(linear).has_value());
}

}  // namespace braidzone
