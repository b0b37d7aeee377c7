#include "core/error.hpp"
#include "discrepancy/effect_roughness.hpp"
#include "discrepancy/explanation.hpp"
#include "support/answers.hpp"
#include "support/linear_problem.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

double normal_density(double x, double variance)
{
    return std::exp(-0.5 * x * x / variance) / std::sqrt(2.0 * std::numbers::pi * variance);
}

/// Sixty places: effect a is a bump; b lifts all places by 0.2 a unit, and each at random by 0.5.
DiagnosisProblem rough_problem(double lift, double scatter)
{
    constexpr Eigen::Index size = 60;
    test::LinearProblem linear;
    linear.fingerprints.resize(size, 2);
    linear.fingerprints << test::bump(size, 30.0, 6.0), Eigen::VectorXd::Constant(size, 0.2);
    linear.data = Eigen::VectorXd::Constant(size, lift) + test::white_noise(size, 3) +
                  scatter * test::white_noise(size, 4);
    DiagnosisProblem problem = linear.problem();
    problem.candidates[1].parameters = {normal_parameter("size", "1", 0.0, 5.0, 0.0, 20.0)};
    problem.candidates[1].roughness = [](const std::vector<double>& values) {
        return Eigen::VectorXd::Constant(size, 0.5 * values.front());
    };
    return problem;
}

}  // namespace

// One residual r = 2 that the effect only makes rough, by its amplitude a of prior N(0, 1) between
// 0 and 4: the mean over a of N(2; 0, 1 + (f a)^2) / N(2; 0, 1), f = 0.6, 1, 1 and 1.6 alike often.
TEST(FitRoughEffect, HasTheEvidenceOfTheIntegralOverItsPrior)
{
    test::LinearProblem linear{Eigen::MatrixXd::Zero(1, 1), Eigen::VectorXd::Constant(1, 2.0)};
    DiagnosisProblem problem = linear.problem();
    problem.candidates[0].parameters = {normal_parameter("size", "1", 0.0, 1.0, 0.0, 4.0)};
    problem.candidates[0].roughness = [](const std::vector<double>& values) {
        return Eigen::VectorXd::Constant(1, values.front());
    };
    double above = 0.0, below = 0.0, first = 0.0;
    for (int i = 0; i < 40000; ++i) {
        const double a = (i + 0.5) * 1e-4, prior = normal_density(a, 1.0);
        for (const double f : {0.6, 1.0, 1.0, 1.6}) {
            const double likelihood = 0.25 * normal_density(2.0, 1.0 + f * f * a * a);
            above += prior * likelihood;
            first += prior * likelihood * a;
        }
        below += prior;
    }
    const EffectFit fit = fit_rough_effect(problem, linear.data, 0);
    EXPECT_NEAR(fit.log_evidence, std::log(above / below / normal_density(2.0, 1.0)), 0.02);
    EXPECT_NEAR(fit.effects.front().values.front(), first / above, 0.02);
}

// Lifted by 0.8 and rough by 2, that is an amplitude of 4.
TEST(FitRoughEffect, IsNamedByWhatItDoesAtRandom)
{
    const Explanation found = explain(rough_problem(0.8, 2.0));
    EXPECT_EQ(test::answers(found), std::vector<std::string>{"b"});
    const FittedEffect& effect = found.fits[*found.best].effects.front();
    EXPECT_NEAR(effect.values.front(), 4.0, 2.0 * effect.sd.front());
    EXPECT_LT(effect.sd.front(), 1.5);
}

TEST(FitRoughEffect, IsNotNamedWhereNothingIsRough)
{
    EXPECT_EQ(test::answers(explain(rough_problem(0.0, 0.0))),
              std::vector<std::string>{"nothing_missing"});
}

TEST(FitRoughEffect, TakesOneParameter)
{
    DiagnosisProblem problem = rough_problem(0.0, 0.0);
    problem.candidates[1].parameters.push_back(problem.candidates[1].parameters.front());
    EXPECT_THROW(fit_rough_effect(problem, problem.residuals({}), 1), InputError);
}

}  // namespace braidzone
