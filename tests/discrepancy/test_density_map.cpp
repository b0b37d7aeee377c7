#include "core/error.hpp"
#include "discrepancy/density_map.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

using testing::HasSubstr;

DensityMap read(const std::string& text)
{
    const test::TemporaryFolder folder;
    return read_density_map(folder.write("density.csv", text));
}

std::string refusal(const std::string& text)
{
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

const std::string pores = "x_mm,y_mm,z_mm,pore_density_per_mm2,sd_per_mm2\n";
const std::string covered = "x_mm,y_mm,z_mm,metal_coverage_percent,sd_percent\n";

}  // namespace

TEST(DensityMap, IsReadInSiUnits)
{
    const DensityMap map = read(pores + "1,-2,14.5,27.5,3\n\n4,5,6,20,2\n");
    EXPECT_EQ(map.quantity, DensityQuantity::pore_density);
    ASSERT_EQ(map.places.size(), 2u);
    EXPECT_LT((map.places[0].point - Vec3(1e-3, -2e-3, 14.5e-3)).norm(), 1e-15);
    EXPECT_DOUBLE_EQ(map.places[0].value, 27.5e6);
    EXPECT_DOUBLE_EQ(map.places[0].sd, 3e6);
    EXPECT_DOUBLE_EQ(map.places[0].window, 1.5e-3);
    EXPECT_EQ(map.places[1].line, 4);
}

TEST(DensityMap, TakesAnyOfItsQuantitiesAndAWindow)
{
    const DensityMap share = read("x_m,y_m,z_m,metal_coverage,sd,window_mm\n0,0,0.01,0.3,0.05,2\n");
    EXPECT_EQ(share.quantity, DensityQuantity::metal_coverage);
    EXPECT_DOUBLE_EQ(share.places[0].point.z(), 0.01);
    EXPECT_DOUBLE_EQ(share.places[0].window, 2e-3);
    EXPECT_DOUBLE_EQ(read(covered + "0,0,0,30,5\n").places[0].value, 0.3);
    const DensityMap increase =
        read("x_um,y_um,z_um,surface_density_increase_percent,sd_percent\n0,0,0,128,10\n");
    EXPECT_EQ(increase.quantity, DensityQuantity::surface_density_increase);
    EXPECT_DOUBLE_EQ(increase.places[0].value, 1.28);
    EXPECT_DOUBLE_EQ(increase.places[0].sd, 0.1);
}

TEST(DensityMap, RefusesWhatIsNone)
{
    EXPECT_THAT(refusal("x,y,z,density,sd\n0,0,0,1,1\n"),
                HasSubstr("density.csv:1: \"x,y,z,density,sd\" is not the header of a density "
                          "map; expected is x_mm,y_mm,z_mm"));
    EXPECT_THAT(refusal("x_mm,y_mm,z_mm,metal_coverage,sd_percent\n0,0,0,1,1\n"),
                HasSubstr("is not the header"));
    EXPECT_THAT(refusal(pores), HasSubstr("no place follows the header"));
    EXPECT_THAT(refusal(pores + "0,0,0,20\n"), HasSubstr(":2: has 4 values; the header has 5"));
    EXPECT_THAT(refusal(pores + "0,0,0,nan,1\n"), HasSubstr("\"nan\" is not a finite number"));
    EXPECT_THAT(refusal(pores + "0,0,0,20,-1\n"),
                HasSubstr("sd_per_mm2 = -1; a standard deviation must be positive"));
    EXPECT_THAT(refusal(pores + "0,0,0,0,1\n"),
                HasSubstr("pore_density_per_mm2 = 0; it must be above 0"));
    EXPECT_THAT(refusal(covered + "0,0,0,101,1\n"),
                HasSubstr("metal_coverage_percent = 101; it must be between 0 and 100"));
    EXPECT_THAT(refusal("x_mm,y_mm,z_mm,metal_coverage,sd,window_mm\n0,0,0,0.3,0.1,9\n"),
                HasSubstr("window_mm = 9; it must be between 0.5 and 5"));
    EXPECT_THROW(read_density_map("/nowhere/density.csv"), IoError);
}

}  // namespace braidzone
