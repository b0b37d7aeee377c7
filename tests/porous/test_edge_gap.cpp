#include "core/error.hpp"
#include "porous/edge_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

const Fluid blood{1056.0, 3.5e-3};

}  // namespace

// A slit of 100 um, 60 um long: 32 / (pi 1e-4) = 101859, 12 * 6e-5 / 1e-8 = 72000, times 3.5e-3:
// 608.51 Pa s/m. Cd = pi / (pi + 2) = 0.61102: 528 / 0.37334 = 1414.3 Pa s^2/m^2, by hand.
TEST(SlitLoss, MatchesHandCalculation)
{
    const SheetLoss loss = slit_loss(100e-6, 60e-6, blood);
    EXPECT_NEAR(loss.linear, 608.51, 0.01);
    EXPECT_NEAR(loss.quadratic, 1414.3, 0.1);
}

TEST(SlitLoss, RefusesANegativeWidth)
{
    EXPECT_THROW(slit_loss(0.0, 60e-6, blood), InputError);
    EXPECT_THROW(slit_loss(std::nan(""), 60e-6, blood), InputError);
}

TEST(VelocityAt, IsTheInverseOfThePressureDrop)
{
    for (const SheetLoss& loss : {SheetLoss{490.0, 330.0}, SheetLoss{490.0, 0.0}})
        EXPECT_NEAR(velocity_at(loss, pressure_drop(loss, 0.17)), 0.17, 1e-14);
}

// Where both paths are alike, the share of either does not matter.
TEST(ParallelPressureDrop, OfTwoEqualPathsIsThatOfOne)
{
    const SheetLoss loss{490.0, 330.0};
    for (const double share : {0.0, 0.1, 0.7})
        EXPECT_NEAR(parallel_pressure_drop(loss, loss, share, 0.2), pressure_drop(loss, 0.2),
                    1e-10);
}

// Linear losses a and a_g in parallel: dp = v / ((1 - g) / a + g / a_g).
// 0.2 / (0.9 / 500 + 0.1 / 100) = 71.43 Pa, by hand.
TEST(ParallelPressureDrop, AddsConductancesOfLinearLosses)
{
    EXPECT_NEAR(parallel_pressure_drop({500.0, 0.0}, {100.0, 0.0}, 0.1, 0.2), 71.428571, 1e-5);
}

TEST(ParallelPressureDrop, LetsAllFluidThrough)
{
    const SheetLoss sheet{490.0, 330.0}, gap{608.0, 1414.0};
    const double dp = parallel_pressure_drop(sheet, gap, 0.12, 0.25);
    EXPECT_NEAR(0.88 * velocity_at(sheet, dp) + 0.12 * velocity_at(gap, dp), 0.25, 1e-12);
    EXPECT_DOUBLE_EQ(parallel_pressure_drop(sheet, gap, 0.12, -0.25), -dp);
}

TEST(ParallelPressureDrop, RefusesAShareThatIsNone)
{
    EXPECT_THROW(parallel_pressure_drop({1.0, 0.0}, {1.0, 0.0}, 1.0, 0.1), InputError);
    EXPECT_THROW(parallel_pressure_drop({1.0, 0.0}, {1.0, 0.0}, -0.1, 0.1), InputError);
}

}  // namespace braidzone
