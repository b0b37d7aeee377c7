#include "core/error.hpp"
#include "porous/resistance_sheet.hpp"
#include "support/braids.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

constexpr double wire_diameter = 30e-6;
const Fluid fluid{1000.0, 4e-3};
const ConstantLaw law{{400.0, 300.0}};

/// One row of square cells of 0.2 mm at the given distances from the wall.
BraidSurface row_of_cells(const std::vector<double>& wall_distances)
{
    BraidSurface surface =
        test::flat_braid(Vec3::Zero(), Vec3(0.2e-3, 0, 0), static_cast<int>(wall_distances.size()),
                         Vec3(0, 0.2e-3, 0), 1, wire_diameter);
    surface.wall_distance = wall_distances;
    return surface;
}

// The cubic step passes 1/2 in the middle, 5/32 at a quarter (t^2 (3 - 2 t) with t = 1/4).
TEST(MakeResistanceSheet, ActsWhereTheDeviceIsFreeOfTheWall)
{
    const double d = wire_diameter;
    const ResistanceSheet sheet =
        make_resistance_sheet(row_of_cells({0.0, d, 1.5 * d, 2.0 * d, 3.0 * d, 1.0}), law, fluid);
    EXPECT_EQ(sheet.acting[0], 0.0);
    EXPECT_EQ(sheet.acting[1], 0.0);
    EXPECT_NEAR(sheet.acting[2], 5.0 / 32.0, 1e-12);
    EXPECT_NEAR(sheet.acting[3], 0.5, 1e-12);
    EXPECT_NEAR(sheet.acting[4], 1.0, 1e-12);
    EXPECT_EQ(sheet.acting[5], 1.0);
}

TEST(MakeResistanceSheet, WholeDeviceActsEverywhere)
{
    const ResistanceSheet sheet = make_resistance_sheet(row_of_cells({0.0, 1.0}), law, fluid,
                                                        {.region = ResistanceRegion::whole_device});
    EXPECT_EQ(sheet.acting[0], 1.0);
    EXPECT_EQ(sheet.acting[1], 1.0);
}

TEST(MakeResistanceSheet, ASheetWithoutAWallActs)
{
    const BraidSurface surface =
        test::flat_braid(Vec3::Zero(), Vec3::UnitX(), 1, Vec3::UnitY(), 1, wire_diameter);
    EXPECT_EQ(make_resistance_sheet(surface, law, fluid).acting[0], 1.0);
}

TEST(MakeResistanceSheet, KeepsTheLossOfTheLocalBraidOnTheWall)
{
    const ResistanceSheet sheet = make_resistance_sheet(row_of_cells({0.0}), law, fluid);
    EXPECT_EQ(sheet.losses[0].linear, 400.0);
    EXPECT_EQ(sheet_darcy(sheet, 0), 0.0);
    EXPECT_EQ(sheet_forchheimer(sheet, 0), 0.0);
}

// D = a / mu = 400 / 4e-3 = 1e5 1/m, F = 2 b / rho = 600 / 1000. With them the sink integrates to
// mu D v + 1/2 rho F v^2 = a v + b v^2.
TEST(SheetDarcy, IsLinearLossOverViscosity)
{
    const ResistanceSheet sheet = make_resistance_sheet(row_of_cells({1.0}), law, fluid);
    EXPECT_NEAR(sheet_darcy(sheet, 0), 1e5, 1e-7);
    EXPECT_NEAR(sheet_forchheimer(sheet, 0), 0.6, 1e-12);
}

// 1e5 1/m over one cell of 0.04 mm^2 and half of another: 6e-3 m.
TEST(ResistanceIntegral, SumsOverTheActingSheet)
{
    const ResistanceSheet sheet =
        make_resistance_sheet(row_of_cells({1.0, 2.0 * wire_diameter, 0.0}), law, fluid);
    EXPECT_NEAR(resistance_integral(sheet), 6e-3, 1e-14);
}

TEST(MakeResistanceSheet, RefusesNegativeRatiosAndBadFluids)
{
    const BraidSurface surface = row_of_cells({1.0});
    for (const double ratio : {-0.1, std::nan("")}) {
        EXPECT_THROW(make_resistance_sheet(surface, law, fluid, {.tangential_ratio = ratio}),
                     ConfigError);
    }
    EXPECT_THROW(make_resistance_sheet(surface, law, Fluid{1000.0, 0.0}), ConfigError);
    EXPECT_THROW(make_resistance_sheet(surface, law, Fluid{std::nan(""), 1e-3}), ConfigError);
}

// Two cells of one sheet and one of another with 20 um wires, half acting.
TEST(Joined, HoldsBothSheetsOneAfterTheOther)
{
    const ResistanceSheet first = make_resistance_sheet(row_of_cells({1.0, 1.0}), law, fluid);
    BraidSurface thin =
        test::flat_braid(Vec3(0, 0, 1e-3), Vec3(0.3e-3, 0, 0), 1, Vec3(0, 0.1e-3, 0), 1, 20e-6);
    thin.wall_distance = {40e-6};
    const ResistanceSheet second = make_resistance_sheet(thin, ConstantLaw{{100.0, 50.0}}, fluid);
    const ResistanceSheet both = joined(first, second);
    ASSERT_EQ(both.losses.size(), 3U);
    ASSERT_EQ(both.acting.size(), 3U);
    EXPECT_EQ(both.losses[0].linear, 400.0);
    EXPECT_EQ(both.losses[2].linear, 100.0);
    EXPECT_NEAR(both.acting[2], 0.5, 1e-12);
    EXPECT_EQ(both.fluid.viscosity, fluid.viscosity);
    // 1e5 1/m over 2 x 0.04 mm^2, and 0.5 x 100 / 4e-3 over 0.03 mm^2.
    EXPECT_NEAR(resistance_integral(both), 8e-3 + 0.375e-3, 1e-14);
    EXPECT_DOUBLE_EQ(resistance_integral(both),
                     resistance_integral(first) + resistance_integral(second));
}

TEST(Joined, RefusesSheetsOfDifferentFluidsOrTangentialRatios)
{
    const BraidSurface surface = row_of_cells({1.0});
    const ResistanceSheet sheet = make_resistance_sheet(surface, law, fluid);
    const std::vector<ResistanceSheet> others = {
        make_resistance_sheet(surface, law, Fluid{1000.0, 3e-3}),
        make_resistance_sheet(surface, law, Fluid{1050.0, 4e-3}),
        make_resistance_sheet(surface, law, fluid, {.tangential_ratio = 2.0})};
    for (const ResistanceSheet& other : others) {
        try {
            joined(sheet, other);
            ADD_FAILURE() << "nothing was thrown";
        } catch (const InputError& error) {
            EXPECT_STREQ(error.what(),
                         "two sheets with different fluids or tangential ratios cannot be joined");
        }
    }
}

}  // namespace
}  // namespace braidzone
