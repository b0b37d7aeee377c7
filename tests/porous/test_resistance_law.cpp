#include "core/error.hpp"
#include "porous/braid_stokes.hpp"
#include "porous/range_check.hpp"
#include "porous/resistance_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double um = 1e-6;
const Fluid fluid;

Rhombus pore(double spacing_um, double wire_um)
{
    return measure_rhombus(Vec3(spacing_um * um, 0, 0), Vec3(0, spacing_um * um, 0), wire_um * um,
                           Vec3::UnitX());
}

TEST(LawName, IsThatOfTheCaseFile)
{
    EXPECT_EQ(law_name(BraidStokesLaw{}), "braid-stokes");
    EXPECT_EQ(law_name(ConstantLaw{}), "constant");
    EXPECT_EQ(law_names(),
              (std::vector<std::string>{"braid-stokes", "brundrett", "gedeon-wood", "ergun",
                                        "idelchik", "armour-cannon", "measured", "constant"}));
}

TEST(SheetLoss, BraidStokesHasBothParts)
{
    const Rhombus cell = pore(190, 33);
    const SheetLoss loss = sheet_loss(BraidStokesLaw{}, cell, fluid);
    EXPECT_DOUBLE_EQ(loss.linear, braid_stokes_linear(cell, fluid.viscosity));
    EXPECT_DOUBLE_EQ(loss.quadratic, braid_stokes_quadratic(cell, fluid.density));
}

TEST(SheetLoss, InertiaCanBeSwitchedOff)
{
    const Rhombus cell = pore(190, 33);
    const SheetLoss loss = sheet_loss(BraidStokesLaw{.inertia = false}, cell, fluid);
    EXPECT_DOUBLE_EQ(loss.linear, braid_stokes_linear(cell, fluid.viscosity));
    EXPECT_EQ(loss.quadratic, 0.0);
}

TEST(SheetLoss, ConstantLawGivesItsValuesEverywhere)
{
    const ConstantLaw law{{400.0, 300.0}};
    for (const double spacing : {100.0, 200.0}) {
        const SheetLoss loss = sheet_loss(law, pore(spacing, 30), fluid);
        EXPECT_EQ(loss.linear, 400.0);
        EXPECT_EQ(loss.quadratic, 300.0);
    }
}

// Wires of 30 um every 31 um: solidity 0.968. The nearest square cell that is not jammed has them
// every 30 / 0.95 = 31.58 um; with one law and the constant one, which needs no pore.
TEST(SheetLoss, AJammedRhombusHasTheLossOfTheNearestThatIsNot)
{
    const SheetLoss at_limit = sheet_loss(BraidStokesLaw{}, pore(30 / 0.95, 30), fluid);
    const SheetLoss jammed = sheet_loss(ResistanceLaw{BraidStokesLaw{}}, pore(31, 30), fluid);
    EXPECT_NEAR(jammed.linear, at_limit.linear, 1e-6 * at_limit.linear);
    EXPECT_NEAR(jammed.quadratic, at_limit.quadratic, 1e-6 * at_limit.quadratic);
    EXPECT_THROW(sheet_loss(BraidStokesLaw{}, pore(31, 30), fluid), InputError);
    EXPECT_EQ(sheet_loss(ResistanceLaw{ConstantLaw{{400.0, 300.0}}}, pore(31, 30), fluid).linear,
              400.0);
}

// Two families 60 um long each at 25 degrees: p = 60 sin 25 = 25.4 um, less than the wires. Opened
// until p = 31.58 um, at asin(31.58 / 60) = 31.76 degrees; the edges keep their length.
TEST(OpenedToLimit, OpensTheCrossingAngleUntilTheWiresPart)
{
    const double angle = 25.0 * std::numbers::pi / 180.0;
    const Rhombus jammed =
        measure_rhombus(60e-6 * Vec3::UnitX(), 60e-6 * Vec3(std::cos(angle), std::sin(angle), 0.0),
                        30e-6, Vec3::UnitX());
    ASSERT_TRUE(is_jammed(jammed));
    const Rhombus opened = opened_to_limit(jammed);
    EXPECT_FALSE(is_jammed(opened));
    EXPECT_NEAR(densest_solidity(opened), 0.95, 1e-12);
    EXPECT_NEAR(opened.edge_a.norm(), 60e-6, 1e-15);
    EXPECT_NEAR(opened.edge_b.norm(), 60e-6, 1e-15);
    EXPECT_NEAR(opened.crossing_angle, std::asin(30.0 / 0.95 / 60.0), 1e-12);
}

TEST(OpenedToLimit, LeavesAnyOtherCellAsItIs)
{
    EXPECT_EQ(opened_to_limit(pore(33, 30)).area, pore(33, 30).area);
}

TEST(RangeWarnings, CountsRhombiOutsideTheVerifiedSolidities)
{
    const std::vector<Rhombus> rhombi{pore(200, 30), pore(400, 30), pore(60, 30), pore(50, 30)};
    const auto warnings = range_warnings(BraidStokesLaw{}, rhombi, fluid);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings[0].find("1 of 4"), std::string::npos);
    EXPECT_NE(warnings[0].find("0.075"), std::string::npos);
    EXPECT_NE(warnings[1].find("2 of 4"), std::string::npos);
    EXPECT_NE(warnings[1].find("0.6"), std::string::npos);
}

// The layer's void fraction of the reference cell is 0.85: above that of Gedeon and Wood's stacks
// (0.78) and of packed beds (0.65).
TEST(RangeWarnings, OfTheLiteratureNameTheirQuantity)
{
    const std::vector<Rhombus> rhombi{pore(190, 33)};
    const auto gedeon_wood = range_warnings(GedeonWoodLaw{}, rhombi, fluid);
    ASSERT_EQ(gedeon_wood.size(), 1U);
    EXPECT_EQ(gedeon_wood[0].find("gedeon-wood: 1 of 1 rhombi have a void fraction of a layer of "
                                  "two wire diameters above 0.78, up to 0.86"),
              0U)
        << gedeon_wood[0];
    EXPECT_EQ(range_warnings(ErgunLaw{}, rhombi, fluid).size(), 1U);
    EXPECT_TRUE(range_warnings(BrundrettLaw{}, rhombi, fluid).empty());
    EXPECT_TRUE(range_warnings(IdelchikLaw{}, rhombi, fluid).empty());
    EXPECT_TRUE(range_warnings(ArmourCannonLaw{}, rhombi, fluid).empty());
}

// Re_d = 1056 0.05 400e-6 / 3.5e-3 = 6.0 for wires of 0.4 mm.
TEST(RangeWarnings, HoldTheReynoldsNumberAgainstTheRange)
{
    const auto warnings = range_warnings(BraidStokesLaw{}, {pore(2000, 400)}, fluid);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("Reynolds number of the wire at 0.05 m/s above 4, up to 6.03429"),
              std::string::npos)
        << warnings[0];
}

TEST(RangeWarnings, AreAbsentWithinTheRangeAndForConstants)
{
    EXPECT_TRUE(range_warnings(BraidStokesLaw{}, {pore(200, 30), pore(100, 30)}, fluid).empty());
    EXPECT_TRUE(range_warnings(ConstantLaw{}, {pore(31, 30)}, fluid).empty());
}

}  // namespace
}  // namespace braidzone
