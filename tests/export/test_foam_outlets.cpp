#include "core/error.hpp"
#include "export/foam_boundary_conditions.hpp"
#include "export/foam_outlets.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace braidzone {
namespace {

/// Openings of radius 3, 2 and 1 mm (areas in the ratio 9 : 4 : 1).
Vessel three_openings()
{
    Vessel vessel;
    for (const double radius : {3e-3, 2e-3, 1e-3}) {
        Opening opening;
        opening.area = radius * radius;  // any common factor
        vessel.openings.push_back(opening);
    }
    return vessel;
}

std::string message(const FoamOutlets& outlets, int inlet = 0)
{
    try {
        foam_openings(three_openings(), inlet, outlets);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

// 2^3 : 1^3. The larger outlet is left to the pressure.
TEST(FoamOpenings, MurraysSharesAreCubesOfRadii)
{
    const auto openings = foam_openings(three_openings(), 0, MurraySplit{});
    ASSERT_EQ(openings.size(), 3U);
    EXPECT_TRUE(openings[0].is_inlet());
    EXPECT_EQ(openings[1].name, "outlet_1");
    EXPECT_FALSE(openings[1].share.has_value());
    EXPECT_EQ(openings[1].pressure, 0.0);
    EXPECT_NEAR(openings[2].share.value(), 1.0 / 9.0, 1e-15);
}

// Inlet 1: outlet_1 is opening 0, outlet_2 opening 2. The larger share is given to the smaller one.
TEST(FoamOpenings, GivenSharesAreThoseOfTheOutletsInTheirOrder)
{
    const auto openings = foam_openings(three_openings(), 1, OutletShares{{0.3, 0.7}});
    EXPECT_EQ(openings[0].name, "outlet_1");
    EXPECT_EQ(openings[0].share.value(), 0.3);
    EXPECT_FALSE(openings[2].share.has_value());
}

TEST(FoamOpenings, PressuresAreThoseOfTheOutletsInTheirOrder)
{
    const auto openings = foam_openings(three_openings(), 0, OutletPressures{{10.0, -20.0}});
    EXPECT_EQ(openings[1].pressure, 10.0);
    EXPECT_EQ(openings[2].pressure, -20.0);
    EXPECT_EQ(foam_openings(three_openings(), 0, OutletPressures{})[2].pressure, 0.0);
}

TEST(FoamOpenings, RefusesWhatDoesNotFitTheVessel)
{
    EXPECT_EQ(message(OutletPressures{{1.0, 2.0, 3.0}}),
              "3 outlet pressures for 2 outlets; one each is needed");
    EXPECT_EQ(message(OutletShares{{1.0}}), "1 outlet shares for 2 outlets; one each is needed");
    EXPECT_EQ(message(OutletShares{{1.2, -0.2}}), "share -0.2 of outlet_2; it must be positive");
    EXPECT_EQ(message(OutletShares{{0.5, 0.4}}), "outlet shares sum to 0.9; they must sum to 1");
    EXPECT_EQ(message(OutletPressures{{0.0, std::numeric_limits<double>::infinity()}}),
              "pressure inf Pa at outlet_2; it must be finite");
    EXPECT_EQ(message(MurraySplit{}, 3), "inlet is opening 3; the vessel has openings 0 to 2");
}

// Pa over rho; where the flow is prescribed the pressure is free.
TEST(PressureField, IsKinematic)
{
    const auto given =
        pressure_field(foam_openings(three_openings(), 0, OutletPressures{{2112.0, 0.0}}), 1056.0);
    EXPECT_NE(given.find("outlet_1 { type fixedValue; value uniform 2; }"), std::string::npos)
        << given;
    const auto split = pressure_field(foam_openings(three_openings(), 0, MurraySplit{}), 1056.0);
    EXPECT_NE(split.find("outlet_1 { type fixedValue; value uniform 0; }"), std::string::npos);
    EXPECT_NE(split.find("outlet_2 { type zeroGradient; }"), std::string::npos);
}

}  // namespace
}  // namespace braidzone
