#include "core/error.hpp"
#include "core/quantity.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

struct Example {
    std::string text;
    Dimension dimension;
    double si;
};

class Units : public testing::TestWithParam<Example> {};

TEST_P(Units, ConvertToSi)
{
    const Example& example = GetParam();
    EXPECT_DOUBLE_EQ(parse_quantity(example.text, example.dimension), example.si) << example.text;
}

// Conversions by definition: 1 in = 25.4 mm, 1 mmHg = 133.322387415 Pa, 1 l = 1e-3 m^3, 180 deg =
// pi.
INSTANTIATE_TEST_SUITE_P(
    Quantity, Units,
    testing::Values(
        Example{"4 m", Dimension::length, 4.0}, Example{"4 cm", Dimension::length, 0.04},
        Example{"0.25 mm", Dimension::length, 2.5e-4}, Example{"30 um", Dimension::length, 30e-6},
        Example{"0.027 in", Dimension::length, 0.6858e-3}, Example{"2 m^2", Dimension::area, 2.0},
        Example{"0.3 mm^2", Dimension::area, 3e-7}, Example{"3 cm^2", Dimension::area, 3e-4},
        Example{"5 um^2", Dimension::area, 5e-12}, Example{"2 s", Dimension::time, 2.0},
        Example{"2 ms", Dimension::time, 2e-3}, Example{"0.25 m/s", Dimension::velocity, 0.25},
        Example{"25 cm/s", Dimension::velocity, 0.25},
        Example{"250 mm/s", Dimension::velocity, 0.25},
        Example{"1056 kg/m^3", Dimension::density, 1056.0},
        Example{"1.056 g/cm^3", Dimension::density, 1056.0},
        Example{"0.0035 Pa s", Dimension::dynamic_viscosity, 3.5e-3},
        Example{"3.5 mPa s", Dimension::dynamic_viscosity, 3.5e-3},
        Example{"3.5 cP", Dimension::dynamic_viscosity, 3.5e-3},
        Example{"10 Pa", Dimension::pressure, 10.0}, Example{"10 kPa", Dimension::pressure, 1e4},
        Example{"200 GPa", Dimension::pressure, 200e9}, Example{"5 MPa", Dimension::pressure, 5e6},
        Example{"100 mmHg", Dimension::pressure, 13332.2387415},
        Example{"1 N", Dimension::force, 1.0}, Example{"2 mN", Dimension::force, 2e-3},
        Example{"2 uN", Dimension::force, 2e-6}, Example{"0.6 N/m", Dimension::stiffness, 0.6},
        Example{"600 mN/m", Dimension::stiffness, 0.6},
        Example{"0.6 mN/mm", Dimension::stiffness, 0.6},
        Example{"2 N/mm", Dimension::stiffness, 2000.0},
        Example{"1e8 Pa/m", Dimension::wall_stiffness, 1e8},
        Example{"2 N/m^3", Dimension::wall_stiffness, 2.0},
        Example{"100 kPa/mm", Dimension::wall_stiffness, 1e8},
        Example{"0.1 kPa/um", Dimension::wall_stiffness, 1e8},
        Example{"0.1 MPa/mm", Dimension::wall_stiffness, 1e8},
        Example{"1e-6 m^3/s", Dimension::flow_rate, 1e-6},
        Example{"4 ml/s", Dimension::flow_rate, 4e-6},
        Example{"240 ml/min", Dimension::flow_rate, 4e-6},
        Example{"0.24 l/min", Dimension::flow_rate, 4e-6},
        Example{"1.5 rad", Dimension::angle, 1.5},
        Example{"180 deg", Dimension::angle, 3.14159265358979323846},
        Example{"0.03 kg/s", Dimension::damping, 0.03},
        Example{"0.03 N s/m", Dimension::damping, 0.03},
        Example{"490 Pa s/m", Dimension::linear_loss, 490.0},
        Example{"330 Pa s^2/m^2", Dimension::quadratic_loss, 330.0},
        Example{"330 kg/m^3", Dimension::quadratic_loss, 330.0}));

TEST(Quantity, IsTheNearestDoubleForPlainNumbers)
{
    // 30 * 1e-6 is not the double nearest to 3e-5.
    EXPECT_EQ(parse_quantity("30 um", Dimension::length), 3e-5);
    EXPECT_EQ(parse_quantity("0.1 mm", Dimension::length), 1e-4);
}

TEST(Quantity, AcceptsSignsExponentsAndWhiteSpace)
{
    EXPECT_EQ(parse_quantity("  -1.5e1 mm ", Dimension::length), -0.015);
    EXPECT_EQ(parse_quantity("+2mm", Dimension::length), 0.002);
    EXPECT_EQ(parse_quantity("3.5\tmPa s", Dimension::dynamic_viscosity), 3.5e-3);
}

std::string message_of(const std::string& text, Dimension dimension)
{
    try {
        parse_quantity(text, dimension);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Quantity, RefusesWhatIsNoNumberWithAUnitOfTheDimension)
{
    const std::string expected = "; expected is a number with a unit of length: m, cm, mm, um, in";
    EXPECT_EQ(message_of("30", Dimension::length), "\"30\" has no unit" + expected);
    EXPECT_EQ(message_of("30 kg", Dimension::length), "\"30 kg\" has the unit \"kg\"" + expected);
    EXPECT_EQ(message_of("30 MM", Dimension::length), "\"30 MM\" has the unit \"MM\"" + expected);
    EXPECT_EQ(message_of("3,5 mm", Dimension::length),
              "\"3,5 mm\" has the unit \",5 mm\"" + expected);
    EXPECT_EQ(message_of("mm", Dimension::length),
              "\"mm\" does not start with a number" + expected);
    EXPECT_EQ(message_of("", Dimension::length), "\"\" does not start with a number" + expected);
    EXPECT_EQ(message_of("+-3 mm", Dimension::length),
              "\"+-3 mm\" does not start with a number" + expected);
    EXPECT_EQ(message_of("nan mm", Dimension::length),
              "\"nan mm\" is not a finite number" + expected);
    EXPECT_EQ(message_of("inf mm", Dimension::length),
              "\"inf mm\" is not a finite number" + expected);
    EXPECT_EQ(message_of("1e999 mm", Dimension::length),
              "\"1e999 mm\" is not a finite number" + expected);
}

TEST(Quantity, FormatsAValueThatReadsBackTheSame)
{
    EXPECT_EQ(format_quantity(3e-5, Dimension::length), "3e-05 m");
    for (const double value : {1.0 / 3.0, 6.8579999999999997e-4, -2.5, 0.0}) {
        const std::string text = format_quantity(value, Dimension::dynamic_viscosity);
        EXPECT_EQ(parse_quantity(text, Dimension::dynamic_viscosity), value) << text;
    }
}

TEST(Quantity, NamesItsDimension)
{
    EXPECT_EQ(si_unit(Dimension::dynamic_viscosity), "Pa s");
    EXPECT_EQ(dimension_name(Dimension::dynamic_viscosity), "dynamic viscosity");
    EXPECT_EQ(allowed_units(Dimension::dynamic_viscosity), "Pa s, mPa s, cP");
}

}  // namespace
}  // namespace braidzone
