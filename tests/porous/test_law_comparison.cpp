#include "porous/law_comparison.hpp"
#include "support/braids.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace braidzone {
namespace {

const Fluid fluid{1056.0, 3.5e-3};

/// Square cells of 0.19 mm of 33 um wires, the first `num_free` of them free of the wall.
ResistanceSheet row_of_cells(int num_free, int num_on_wall)
{
    BraidSurface surface = test::flat_braid(Vec3::Zero(), Vec3(0.19e-3, 0, 0),
                                            num_free + num_on_wall, Vec3(0, 0.19e-3, 0), 1, 33e-6);
    for (int i = num_free; i < num_free + num_on_wall; ++i)
        surface.wall_distance[static_cast<std::size_t>(i)] = 0.0;
    return make_resistance_sheet(surface, BraidStokesLaw{}, fluid);
}

TEST(CompareLaws, ListsEveryLawTheRecommendedOneFirst)
{
    const auto laws = compare_laws(row_of_cells(2, 0), BraidStokesLaw{});
    std::vector<std::string> names;
    for (const LawComparison& law : laws)
        names.push_back(law.law);
    EXPECT_EQ(names, (std::vector<std::string>{"braid-stokes", "brundrett", "gedeon-wood", "ergun",
                                               "idelchik", "armour-cannon"}));
    EXPECT_EQ(laws[0].ratio, 1.0);
    const Rhombus cell = row_of_cells(1, 0).surface.rhombi[0];
    const SheetLoss ergun = sheet_loss(ErgunLaw{}, cell, fluid);
    EXPECT_NEAR(laws[3].mean.linear / ergun.linear, 1.0, 1e-12);
    EXPECT_NEAR(laws[3].mean.quadratic / ergun.quadratic, 1.0, 1e-12);
    EXPECT_NEAR(laws[3].ratio, ergun.linear / sheet_loss(BraidStokesLaw{}, cell, fluid).linear,
                1e-12);
}

// 100 Pa s/m over two cells of 0.19 mm: 100 / 3.5e-3 2 (0.19e-3)^2 = 2.0629e-3 m.
TEST(CompareLaws, AppendsTheCasesOwnLawIfItNeedsData)
{
    const ResistanceSheet sheet = row_of_cells(2, 3);
    const auto laws = compare_laws(sheet, ConstantLaw{{100.0, 20.0}});
    ASSERT_EQ(laws.size(), 7U);
    EXPECT_EQ(laws.back().law, "constant");
    EXPECT_DOUBLE_EQ(laws.back().mean.linear, 100.0);
    EXPECT_DOUBLE_EQ(laws.back().mean.quadratic, 20.0);
    EXPECT_NEAR(laws.back().resistance_integral, 2.062857e-3, 1e-9);
    EXPECT_NEAR(laws.back().ratio, 100.0 / laws.front().mean.linear, 1e-12);
    // The recommended law's integral is that of the sheet.
    EXPECT_NEAR(laws.front().resistance_integral / resistance_integral(sheet), 1.0, 1e-12);
}

TEST(CompareLaws, TakesTheCasesOwnOptions)
{
    const auto laws = compare_laws(row_of_cells(1, 0), BraidStokesLaw{.inertia = false});
    ASSERT_EQ(laws.size(), 6U);
    EXPECT_EQ(laws.front().mean.quadratic, 0.0);
}

// A device on the wall all over: the means are those of the whole device.
TEST(CompareLaws, HasMeansWithoutAFreePart)
{
    const auto laws = compare_laws(row_of_cells(0, 2), BraidStokesLaw{});
    EXPECT_GT(laws.front().mean.linear, 100.0);
    EXPECT_EQ(laws.front().resistance_integral, 0.0);
}

}  // namespace
}  // namespace braidzone
