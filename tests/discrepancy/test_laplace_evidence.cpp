#include "discrepancy/laplace_evidence.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace braidzone {

// For z = z0 + S x with x ~ N(0, I) the evidence is N(z0; 0, I + S S'), in closed form.
TEST(LogBayesFactor, IsExactForALinearModel)
{
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto noise = [&] { return normal(random); };
    for (int repeat = 0; repeat < 5; ++repeat) {
        const Eigen::MatrixXd slope = Eigen::MatrixXd::NullaryExpr(30, 3, noise);
        const Eigen::VectorXd base = Eigen::VectorXd::NullaryExpr(30, noise) +
                                     slope * Eigen::VectorXd::NullaryExpr(3, noise);
        const Eigen::VectorXd x =
            -(Eigen::MatrixXd::Identity(3, 3) + slope.transpose() * slope).inverse() *
            slope.transpose() * base;
        const Eigen::MatrixXd covariance =
            Eigen::MatrixXd::Identity(30, 30) + slope * slope.transpose();
        const double exact = -0.5 * base.dot(covariance.inverse() * base) -
                             0.5 * std::log(covariance.determinant()) + 0.5 * base.squaredNorm();
        EXPECT_NEAR(log_bayes_factor(base, base + slope * x, slope, x, {false, false, false}),
                    exact, 1e-9);
    }
}

// One residual z = 3 (x - 0.2), x uniform of standard deviation 1: over its range sqrt(12) the mean
// of exp(-z^2 / 2) is sqrt(2 pi) / 3 / sqrt(12), up to the 1 in 1 + S'S that keeps a parameter
// without any trace finite.
TEST(LogBayesFactor, OfAUniformParameterIsTheMeanOverItsRange)
{
    const double mean = std::sqrt(2.0 * std::numbers::pi) / std::sqrt(9.0 + 1.0) / std::sqrt(12.0);
    const Eigen::VectorXd base = Eigen::VectorXd::Constant(1, -0.6);
    const Eigen::VectorXd fitted = Eigen::VectorXd::Zero(1);
    EXPECT_NEAR(log_bayes_factor(base, fitted, Eigen::MatrixXd::Constant(1, 1, 3.0),
                                 Eigen::VectorXd::Constant(1, 0.2), {true}),
                std::log(mean) + 0.5 * 0.36, 1e-12);
}

TEST(LogBayesFactor, OfAnEffectWithoutTraceIsZero)
{
    const Eigen::VectorXd base = Eigen::VectorXd::Constant(4, 0.7);
    EXPECT_DOUBLE_EQ(log_bayes_factor(base, base, Eigen::MatrixXd::Zero(4, 2),
                                      Eigen::VectorXd::Zero(2), {false, false}),
                     0.0);
}

}  // namespace braidzone
