#include "core/carreau_yasuda.hpp"
#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace braidzone {
namespace {

// At lambda g = 1 the bracket is 2: with a = 2 and n = 0.5 the factor is 2^(-1/4).
TEST(CarreauYasuda, ViscosityMatchesHandCalculation)
{
    const CarreauYasuda blood{0.05, 0.003, 2.0, 0.5, 2.0};
    EXPECT_DOUBLE_EQ(viscosity(blood, 0.5), 0.003 + 0.047 / std::sqrt(std::sqrt(2.0)));
    EXPECT_DOUBLE_EQ(viscosity(blood, 0.0), 0.05);
}

// Far above 1 / lambda the excess over mu_inf falls with the power n - 1.
TEST(CarreauYasuda, FallsWithItsPowerIndex)
{
    const CarreauYasuda blood;
    const auto excess = [&](double shear_rate) {
        return viscosity(blood, shear_rate) - blood.infinite_shear_viscosity;
    };
    EXPECT_NEAR(std::log10(excess(1e6) / excess(1e5)), blood.power_index - 1.0, 1e-4);
}

std::string message(const CarreauYasuda& blood)
{
    try {
        validate(blood);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(CarreauYasuda, RefusesConstantsOutOfRange)
{
    EXPECT_EQ(message({}), "accepted");
    EXPECT_EQ(message({.infinite_shear_viscosity = 0.0}),
              "infinite-shear viscosity [Pa s] 0 is out of range; allowed: above 0");
    EXPECT_EQ(message({.zero_shear_viscosity = 0.003}),
              "zero-shear viscosity [Pa s] 0.003 is out of range; allowed: above the "
              "infinite-shear viscosity");
    EXPECT_EQ(message({.relaxation_time = -1.0}),
              "relaxation time [s] -1 is out of range; allowed: above 0");
    EXPECT_EQ(message({.power_index = 1.0}),
              "power index 1 is out of range; allowed: between 0 and 1");
    EXPECT_EQ(message({.yasuda_exponent = 0.0}),
              "Yasuda exponent 0 is out of range; allowed: above 0");
    EXPECT_EQ(message({.relaxation_time = std::numeric_limits<double>::infinity()}),
              "relaxation time [s] inf is out of range; allowed: above 0");
}

}  // namespace
}  // namespace braidzone
