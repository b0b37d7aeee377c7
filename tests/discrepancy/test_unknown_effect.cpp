#include "discrepancy/unknown_effect.hpp"
#include "support/patch_grid.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace braidzone {
namespace {

Observations cylinder(int rows)
{
    return {.points = {}, .field = test::cylinder_field(rows, 2e-3), .scalars = {}};
}

/// ln N(r; 0, C + K) - ln N(r; 0, C) by determinants and inverses.
double brute_force(const Eigen::MatrixXd& noise, const Eigen::MatrixXd& kernel,
                   const Eigen::VectorXd& residuals)
{
    const auto log_density = [&](const Eigen::MatrixXd& covariance) {
        const Eigen::LDLT<Eigen::MatrixXd> factor(covariance);
        return -0.5 * residuals.dot(factor.solve(residuals)) -
               0.5 * factor.vectorD().array().log().sum();
    };
    return log_density(noise + kernel) - log_density(noise);
}

}  // namespace

TEST(UnknownEffect, HasTheEvidenceOfTheDeterminants)
{
    const Observations observations = cylinder(6);
    const DiagnosisProblem problem = test::errors_of(observations);
    const Eigen::MatrixXd& noise = problem.covariance;
    const Eigen::MatrixXd squares = patch_distances(observations.field).array().square().matrix();
    const Eigen::VectorXd residuals = 2.0 * test::draws(noise, 1, 5).col(0);
    double mean = 0.0;
    for (const double amplitude : {0.04e-3, 0.08e-3, 0.16e-3, 0.32e-3}) {
        for (const double length : {1e-3, 2e-3, 4e-3}) {
            const Eigen::MatrixXd kernel =
                amplitude * amplitude * (-0.5 * squares.array() / (length * length)).exp().matrix();
            mean += std::exp(brute_force(noise, kernel, residuals)) / 12.0;
        }
    }
    const Whitening whitening(noise);
    const UnknownEffect unknown(problem, whitening);
    EXPECT_NEAR(unknown.log_evidence(whitening(residuals)), std::log(mean), 1e-6);
}

TEST(UnknownEffect, SaysNothingAboutScalars)
{
    Observations observations = cylinder(6);
    observations.scalars.values[2] = {20e-3, 0.3e-3};
    const DiagnosisProblem problem = test::errors_of(observations);
    const Whitening whitening(problem.covariance);
    const UnknownEffect unknown(problem, whitening);
    Eigen::VectorXd residuals = Eigen::VectorXd::Zero(num_residuals(observations));
    const double without = unknown.log_evidence(whitening(residuals));
    residuals[residuals.size() - 1] = 5e-3;
    EXPECT_DOUBLE_EQ(unknown.log_evidence(whitening(residuals)), without);
}

// K (C + K)^-1 r at the best amplitude and length: where the dent is, most of it comes back, and
// hardly anything 6 mm away.
TEST(UnknownEffect, FindsADent)
{
    const Observations observations = cylinder(16);
    const DiagnosisProblem problem = test::errors_of(observations);
    const Whitening whitening(problem.covariance);
    const UnknownEffect unknown(problem, whitening);
    const Vec3 place(2e-3, 0.0, 6e-3);
    Eigen::VectorXd residuals(num_residuals(observations));
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        const Vec3& centre = observations.field.patches[static_cast<std::size_t>(i)].centre;
        residuals[i] = -0.3e-3 * std::exp(-0.5 * (centre - place).squaredNorm() / 2e-6);
    }
    EXPECT_GT(unknown.log_evidence(whitening(residuals)), 10.0);
    const Eigen::VectorXd mean = unknown.mean_field(whitening(residuals));
    Eigen::Index deepest = 0;
    residuals.minCoeff(&deepest);
    EXPECT_LT(mean[deepest], 0.5 * residuals[deepest]);
    EXPECT_GT(mean[deepest], 1.1 * residuals[deepest]);
    EXPECT_LT(std::abs(mean[mean.size() - 1]), 0.03e-3);
}

TEST(UnknownEffect, IsRarelySeenInNoise)
{
    const Observations observations = cylinder(16);
    const DiagnosisProblem problem = test::errors_of(observations);
    const Eigen::MatrixXd& noise = problem.covariance;
    const Whitening whitening(noise);
    const UnknownEffect unknown(problem, whitening);
    const Eigen::MatrixXd draws = test::draws(noise, 200, 11);
    int alarms = 0;
    for (Eigen::Index i = 0; i < draws.cols(); ++i)
        alarms += unknown.log_evidence(whitening(draws.col(i))) > 3.4 ? 1 : 0;
    // P(B > b) <= 1 / b = 0.033 for any Bayes factor: 6.7 of 200; 14 has a chance below 1 %.
    EXPECT_LT(alarms, 14);
}

}  // namespace braidzone
