#include "core/error.hpp"
#include "porous/two_term_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace braidzone {
namespace {

TEST(TwoTermFit, FindsTheLawThatTheSamplesFollow)
{
    const SheetLoss law{490.0, 330.0};
    const auto samples =
        sample_loss([&](double velocity) { return pressure_drop(law, velocity); }, 0.2);
    ASSERT_EQ(samples.size(), 20U);
    EXPECT_DOUBLE_EQ(samples.front().velocity, 0.01);
    EXPECT_DOUBLE_EQ(samples.back().velocity, 0.2);
    const SheetLoss fit = two_term_fit(samples);
    EXPECT_NEAR(fit.linear, 490.0, 1e-9 * 490.0);
    EXPECT_NEAR(fit.quadratic, 330.0, 1e-9 * 330.0);
    EXPECT_LT(two_term_error(fit, samples), 1e-9);
}

// By hand: v = 1, 2, 3 with dp = 3, 10, 20. Sums v^2 = 14, v^3 = 36, v^4 = 98, v dp = 83,
// v^2 dp = 223; b = (14 223 - 36 83) / (14 98 - 36^2) = 134 / 76, a = (98 83 - 36 223) / 76.
TEST(TwoTermFit, MatchesHandCalculation)
{
    const SheetLoss fit = two_term_fit({{1.0, 3.0}, {2.0, 10.0}, {3.0, 20.0}});
    EXPECT_NEAR(fit.quadratic, 134.0 / 76.0, 1e-12);
    EXPECT_NEAR(fit.linear, 106.0 / 76.0, 1e-12);
}

// dp = 2, 3.6 at v = 1, 2: bends down, so b = 0 and a = (1 2 + 2 3.6) / 5 = 1.84.
TEST(TwoTermFit, HasNoNegativeQuadraticPart)
{
    const SheetLoss fit = two_term_fit({{1.0, 2.0}, {2.0, 3.6}});
    EXPECT_EQ(fit.quadratic, 0.0);
    EXPECT_NEAR(fit.linear, 1.84, 1e-12);
    EXPECT_NEAR(two_term_error(fit, {{1.0, 2.0}, {2.0, 3.6}}), 0.08, 1e-12);
}

TEST(TwoTermFit, OfOneVelocityIsLinear)
{
    const SheetLoss fit = two_term_fit({{0.1, 49.0}, {0.1, 51.0}});
    EXPECT_NEAR(fit.linear, 500.0, 1e-9);
    EXPECT_EQ(fit.quadratic, 0.0);
}

TEST(TwoTermFit, RefusesWhatIsNoLoss)
{
    EXPECT_THROW(two_term_fit({}), InputError);
    EXPECT_THROW(two_term_fit({{0.0, 1.0}}), InputError);
    EXPECT_THROW(two_term_fit({{std::nan(""), 1.0}}), InputError);
    EXPECT_THROW(two_term_fit({{1.0, std::nan("")}}), InputError);
    try {
        two_term_fit({{1.0, 0.1}, {2.0, 10.0}});
        FAIL() << "a negative linear part was accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("negative linear part a = "), std::string::npos);
    }
}

TEST(PressureDrop, IsOddInTheVelocity)
{
    const SheetLoss loss{490.0, 330.0};
    EXPECT_DOUBLE_EQ(pressure_drop(loss, 0.1), 52.3);
    EXPECT_DOUBLE_EQ(pressure_drop(loss, -0.1), -52.3);
    EXPECT_EQ(pressure_drop(loss, 0.0), 0.0);
}

}  // namespace
}  // namespace braidzone
