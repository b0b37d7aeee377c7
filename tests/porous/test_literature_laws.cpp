// The laws of the literature against their own equations, evaluated by hand for the reference cell:
// 48 wires of 33 um on a 4 mm tube at 69 degrees from the axis (spacing 187.6 um, solidity 0.1759,
// coverage 0.321, void fraction of a layer of two diameters 0.862), in a fluid of 1060 kg/m^3 and
// 3.5 mPa s. With these the pressure drops at 0.01, 0.05, 0.1 and 0.2 m/s, rounded to three digits.

#include "porous/armour_cannon.hpp"
#include "porous/brundrett.hpp"
#include "porous/ergun.hpp"
#include "porous/gedeon_wood.hpp"
#include "porous/idelchik.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace braidzone {
namespace {

const Fluid fluid{1060.0, 3.5e-3};
constexpr std::array<double, 4> velocities{0.01, 0.05, 0.1, 0.2};

Rhombus reference_cell(double scale = 1.0)
{
    const double alpha = 69.0 * std::numbers::pi / 180.0;
    const double around = scale * 4.0 * std::numbers::pi * 2e-3 / 48.0;
    const double edge = 0.5 * around / std::sin(alpha);
    return measure_rhombus(edge * Vec3(std::sin(alpha), std::cos(alpha), 0),
                           edge * Vec3(-std::sin(alpha), std::cos(alpha), 0), scale * 33e-6,
                           Vec3::UnitX());
}

/// Half a unit of the third digit, relative.
constexpr double rounding = 0.006;

/// @param pressure_drop_at  [Pa], of a velocity [m/s]
void expect_drops(const std::function<double(double)>& pressure_drop_at,
                  const std::array<double, 4>& expected)
{
    for (std::size_t i = 0; i < velocities.size(); ++i)
        EXPECT_NEAR(pressure_drop_at(velocities[i]) / expected[i], 1.0, rounding);
}

void expect_drops(const SheetLoss& loss, const std::array<double, 4>& expected)
{
    expect_drops([&](double velocity) { return pressure_drop(loss, velocity); }, expected);
}

TEST(Brundrett, GivesItsPressureDrops)
{
    expect_drops(
        [](double velocity) { return brundrett_pressure_drop(reference_cell(), fluid, velocity); },
        {4.83, 27.6, 59.6, 131.0});
}

// For Re -> 0 only 7.125 / Re is left: a = 3.5625 mu / d (1 - beta^2) / beta^2 = 441 Pa s/m.
TEST(Brundrett, HasALinearLimit)
{
    constexpr double slow = 1e-7;
    EXPECT_NEAR(brundrett_pressure_drop(reference_cell(), fluid, slow) / slow / 441.0, 1.0, 0.003);
}

TEST(Brundrett, TwoTermsFollowItToAFewPercent)
{
    const Rhombus cell = reference_cell();
    const SheetLoss loss = sheet_loss(BrundrettLaw{}, cell, fluid);
    for (const double velocity : {0.02, 0.05, 0.1}) {
        EXPECT_NEAR(pressure_drop(loss, velocity) / brundrett_pressure_drop(cell, fluid, velocity),
                    1.0, 0.03);
    }
}

TEST(GedeonWood, GivesItsPressureDrops)
{
    expect_drops(
        [](double velocity) {
            return gedeon_wood_pressure_drop(reference_cell(), fluid, velocity);
        },
        {4.15, 21.8, 46.2, 102.0});
}

TEST(GedeonWood, TwoTermsFollowItToAPercent)
{
    const Rhombus cell = reference_cell();
    const SheetLoss loss = sheet_loss(GedeonWoodLaw{}, cell, fluid);
    for (const double velocity : {0.005, 0.02, 0.05, 0.1}) {
        EXPECT_NEAR(
            pressure_drop(loss, velocity) / gedeon_wood_pressure_drop(cell, fluid, velocity), 1.0,
            0.01);
    }
}

// a = 150 3.5e-3 0.1381^2 66e-6 / (0.8619^3 (49.5e-6)^2) = 421 Pa s/m.
TEST(Ergun, GivesItsPressureDrops)
{
    const SheetLoss loss = sheet_loss(ErgunLaw{}, reference_cell(), fluid);
    EXPECT_NEAR(loss.linear, 421.0, 1.0);
    expect_drops(loss, {4.27, 22.4, 47.5, 106.0});
}

// a = 11 mu beta / d = 11 3.5e-3 0.679 / 33e-6 = 792 Pa s/m.
// b = 530 (1.3 0.321 + (1 / 0.679 - 1)^2) = 530 (0.417 + 0.223) = 339 kg/m^3.
TEST(Idelchik, GivesItsPressureDrops)
{
    const SheetLoss loss = sheet_loss(IdelchikLaw{}, reference_cell(), fluid);
    EXPECT_NEAR(loss.linear, 792.0, 1.0);
    EXPECT_NEAR(loss.quadratic, 339.0, 1.5);
    expect_drops(loss, {7.96, 40.5, 82.6, 172.0});
}

// a = 8.61 mu (pi / p)^2 2 d / eps^2 = 8.61 3.5e-3 (16746 1/m)^2 66e-6 / 0.743 = 751 Pa s/m.
TEST(ArmourCannon, GivesItsPressureDrops)
{
    const SheetLoss loss = sheet_loss(ArmourCannonLaw{}, reference_cell(), fluid);
    EXPECT_NEAR(loss.linear, 751.0, 1.0);
    expect_drops(loss, {7.54, 38.3, 78.2, 163.0});
}

// dp is (mu / d) v times a function of the density and of Re: twice the size at half the velocity
// (the same Re) gives a quarter of the pressure.
template <typename Law>
class ScreenLaw : public ::testing::Test {
};
using ScreenLaws =
    ::testing::Types<BrundrettLaw, GedeonWoodLaw, ErgunLaw, IdelchikLaw, ArmourCannonLaw>;
TYPED_TEST_SUITE(ScreenLaw, ScreenLaws);

template <typename Law>
Law law_up_to(double velocity)
{
    if constexpr (requires(Law law) { law.fit_velocity; }) {
        return Law{.fit_velocity = velocity};
    } else {
        return Law{};
    }
}

TYPED_TEST(ScreenLaw, ScalesWithSizeAtTheSameReynoldsNumber)
{
    const SheetLoss one = sheet_loss(law_up_to<TypeParam>(0.1), reference_cell(), fluid);
    const SheetLoss two = sheet_loss(law_up_to<TypeParam>(0.05), reference_cell(2.0), fluid);
    EXPECT_NEAR(two.linear / one.linear, 0.5, 1e-9);
    EXPECT_NEAR(two.quadratic / one.quadratic, 1.0, 1e-9);
}

// The linear part is proportional to the viscosity: a fluid k times as viscous at k times the
// velocity has the same Re and k^2 times the pressure.
TYPED_TEST(ScreenLaw, ScalesWithTheViscosityAtTheSameReynoldsNumber)
{
    const Fluid thick{fluid.density, 3.0 * fluid.viscosity};
    const SheetLoss one = sheet_loss(law_up_to<TypeParam>(0.05), reference_cell(), fluid);
    const SheetLoss other = sheet_loss(law_up_to<TypeParam>(0.15), reference_cell(), thick);
    EXPECT_NEAR(other.linear / one.linear, 3.0, 1e-9);
    EXPECT_NEAR(other.quadratic / one.quadratic, 1.0, 1e-9);
}

TYPED_TEST(ScreenLaw, StatesARange)
{
    const auto checks = range_checks(TypeParam{}, reference_cell(), fluid);
    ASSERT_FALSE(checks.empty());
    for (const RangeCheck& check : checks)
        EXPECT_LT(check.lowest, check.highest);
}

}  // namespace
}  // namespace braidzone
