#include "core/error.hpp"
#include "discrepancy/curve_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

// Weights 10 + 0.5 and 5 + 0.5; relative values 20/21 and 10/11. Each part of the covariance alone,
// by hand.
TEST(CurveWeights, CovarianceHasTheStatedParts)
{
    const std::vector<double> x = {0.0, 2.0}, y = {10.0, 5.0};
    const double one = 20.0 / 21.0, two = 10.0 / 11.0;
    const CurveWeights points = make_curve_weights(x, y, 0.0, {.point_sd = 0.1});
    EXPECT_DOUBLE_EQ(points.weights[0], 10.5);
    EXPECT_NEAR(points.covariance(0, 0), 0.01 * one * one, 1e-15);
    EXPECT_DOUBLE_EQ(points.covariance(0, 1), 0.0);

    const CurveWeights scale = make_curve_weights(x, y, 0.0, {.point_sd = 0.1, .scale_sd = 0.2});
    EXPECT_NEAR(scale.nuisance(0, 1), 0.04 * one * two, 1e-15);
    EXPECT_NEAR(scale.covariance(0, 1), 0.04 * one * two, 1e-15);

    const CurveWeights zero = make_curve_weights(x, y, 0.0, {.point_sd = 0.1, .zero_sd = 0.3});
    EXPECT_NEAR(zero.nuisance(0, 1), 0.09 / (10.5 * 5.5), 1e-15);

    // Half the range of 2 apart falls to 1/e over 1: the points are e^-2 alike.
    const CurveWeights background = make_curve_weights(
        x, y, 0.0, {.point_sd = 0.1, .background_sd = 0.2, .background_length = 0.5});
    EXPECT_NEAR(background.covariance(0, 1), 0.04 * one * two * std::exp(-2.0), 1e-15);

    // A slope of -2.5 at both points: 0.1 along the abscissa is 0.25.
    const CurveWeights along = make_curve_weights(
        x, y, 0.0, {.point_sd = 0.1, .background_length = 0.5, .abscissa_sd = 0.1});
    EXPECT_NEAR(along.covariance(0, 1), 0.0625 / (10.5 * 5.5) * std::exp(-2.0), 1e-15);
    EXPECT_NEAR(along.covariance(0, 0), 0.01 * one * one + 0.0625 / (10.5 * 10.5), 1e-15);
}

TEST(CurveWeights, TakesTheRepeatsErrorWhereItIsGreater)
{
    const std::vector<double> x = {0.0, 2.0}, y = {10.0, 5.0};
    const CurveWeights weights = make_curve_weights(x, y, 0.8, {.point_sd = 0.1});
    EXPECT_NEAR(weights.covariance(0, 0), 1.0 / (10.5 * 10.5), 1e-15);
    EXPECT_NEAR(weights.covariance(1, 1), 0.64 / (5.5 * 5.5), 1e-15);
}

TEST(CurveWeights, RefusesACurveOfZeros)
{
    EXPECT_THROW(make_curve_weights({0.0, 1.0}, {0.0, 0.0}, 0.0, force_noise()), InputError);
}

}  // namespace braidzone
