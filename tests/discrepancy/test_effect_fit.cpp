// Fits to measurements that are linear in the effects' sizes, where the answer is known in closed
// form (support/linear_problem.hpp).

#include "core/error.hpp"
#include "discrepancy/effect_fit.hpp"
#include "support/linear_problem.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

const Eigen::VectorXd& data_of(const test::LinearProblem& linear)
{
    return linear.data;
}

/// ln N(d; 0, I + 100 F F') - ln N(d; 0, I).
double exact_evidence(const Eigen::MatrixXd& fingerprints, const Eigen::VectorXd& data)
{
    const Eigen::Index n = data.size();
    const Eigen::MatrixXd covariance =
        Eigen::MatrixXd::Identity(n, n) + 100.0 * fingerprints * fingerprints.transpose();
    return -0.5 * data.dot(covariance.inverse() * data) - 0.5 * std::log(covariance.determinant()) +
           0.5 * data.squaredNorm();
}

}  // namespace

// The posterior of a size under N(0, 10^2): mean F'd / (F'F + 1/100), variance 1 / (F'F + 1/100).
TEST(FitEffect, IsTheNormalPosterior)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 3.0, 0.0, 5);
    const DiagnosisProblem problem = linear.problem();
    const EffectFit fit =
        fit_effect(problem, Whitening(problem.covariance), data_of(linear), 1, {});
    const Eigen::VectorXd bump = linear.fingerprints.col(1);
    const double precision = bump.squaredNorm() + 0.01;
    ASSERT_EQ(fit.effects.size(), 1u);
    EXPECT_EQ(name_of(fit), "b");
    // Steps end where they change the log posterior by less than decides anything.
    EXPECT_NEAR(fit.effects[0].values[0], bump.dot(linear.data) / precision, 1e-3);
    EXPECT_NEAR(fit.effects[0].sd[0], 1.0 / std::sqrt(precision), 1e-6);
    EXPECT_NEAR(fit.log_evidence, exact_evidence(bump, linear.data), 1e-6);
    EXPECT_NEAR(fit.chi_square, (linear.data - fit.effects[0].values[0] * bump).squaredNorm(),
                1e-9);
}

TEST(FitTogether, IsTheNormalPosteriorOfBoth)
{
    const test::LinearProblem linear = test::three_bumps(2.0, 0.0, -3.0, 6);
    const DiagnosisProblem problem = linear.problem();
    const EffectFit fit = fit_together(problem, Whitening(problem.covariance), data_of(linear),
                                       {{0, {0.0}}, {2, {1.0}}});
    Eigen::MatrixXd both(linear.data.size(), 2);
    both << linear.fingerprints.col(0), linear.fingerprints.col(2);
    const Eigen::Matrix2d precision = both.transpose() * both + 0.01 * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d mean = precision.inverse() * both.transpose() * linear.data;
    EXPECT_EQ(name_of(fit), "a + c");
    EXPECT_NEAR(fit.effects[0].values[0], mean[0], 1e-3);
    EXPECT_NEAR(fit.effects[1].values[0], mean[1], 1e-3);
    EXPECT_NEAR(fit.log_evidence, exact_evidence(both, linear.data), 1e-6);
}

// Starts of 20 and 25 where 3 is there leave more than no effect does, but their fingerprint fits.
TEST(FitEffect, BeginsAtStartsThatAreFarTooStrong)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 3.0, 0.0, 5);
    DiagnosisProblem problem = linear.problem();
    problem.candidates[1].starts = {{20.0}, {25.0}};
    const EffectFit fit =
        fit_effect(problem, Whitening(problem.covariance), data_of(linear), 1, {});
    const Eigen::VectorXd bump = linear.fingerprints.col(1);
    ASSERT_GT((linear.data - 20.0 * bump).norm(), linear.data.norm());
    // Where the fingerprint fits best the prior is all that is left: it promises too little a step.
    const double precision = bump.squaredNorm() + 0.01;
    EXPECT_NEAR(fit.effects[0].values[0], bump.dot(linear.data) / precision,
                0.05 / std::sqrt(precision));
}

// A start that promises nothing is left where it is, at the price of the derivatives alone.
TEST(FitEffect, TakesNoStepWhereNothingIsPromised)
{
    test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 7);
    linear.data.setZero();
    const DiagnosisProblem problem = linear.problem();
    const EffectFit fit =
        fit_effect(problem, Whitening(problem.covariance), data_of(linear), 0, {});
    EXPECT_EQ(fit.effects[0].values[0], 0.0);
    EXPECT_EQ(fit.num_runs, 2);
}

TEST(FitEffect, SaysWhyACandidateCannotBeSimulated)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 3.0, 0.0, 5);
    DiagnosisProblem problem = linear.problem();
    problem.residuals = [](const std::vector<ActiveEffect>&) -> Eigen::VectorXd {
        throw GeometryError("the device breaks");
    };
    const EffectFit fit =
        fit_effect(problem, Whitening(problem.covariance), data_of(linear), 1, {});
    EXPECT_EQ(fit.failure, "the device breaks");
    EXPECT_TRUE(std::isinf(fit.log_evidence) && fit.log_evidence < 0.0);
}

}  // namespace braidzone
