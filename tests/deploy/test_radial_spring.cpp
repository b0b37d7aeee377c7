#include "deploy/radial_spring.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

namespace {

/// Bending and torsion of the size of a 4 mm Pipeline's crossings.
constexpr RadialSpring wires = {
    .rest_radius = 2e-3, .bending = 0.2, .torsion = 0.16, .braid_ratio = 0.4};
/// sin b = sin b0 / 2 = 0.2 / sqrt(1.16): cos b = sqrt(1 - 0.04 / 1.16) = cos b0 r / R0.
const double last_radius = 2e-3 * std::sqrt(1.16 - 0.04);

}  // namespace

// 0.1 N/m * 0.15 mm = 15 uN; 0.1 N/m (0.15 mm)^2 / 2.
TEST(RadialSpring, IsALinearSpringWithoutTorsion)
{
    const RadialSpring spring = {
        .rest_radius = 2e-3, .bending = 0.1, .torsion = 0.0, .braid_ratio = 0.0};
    EXPECT_DOUBLE_EQ(radial_force(spring, 1.85e-3), 15e-6);
    EXPECT_NEAR(radial_energy(spring, 1.85e-3), 1.125e-9, 1e-22);
    EXPECT_DOUBLE_EQ(radial_stiffness(spring), 0.1);
    EXPECT_DOUBLE_EQ(radial_stiffness_at(spring, 1e-3), 0.1);
}

// At r = R0 / 2 and t = 0.4: cos b0 = 1 / sqrt(1.16), cos b = 0.464238, sin b = 0.885709,
// sin b0 = 0.371391; f = 0.2 * 1 mm + 0.16 * 1 mm (1 - 0.371391 / 0.885709) = 0.292910 mN.
TEST(RadialForce, MatchesHandCalculationWithTorsion)
{
    EXPECT_NEAR(radial_force(wires, 1e-3), 0.292910e-3, 1e-9);
    EXPECT_NEAR(radial_force(wires, 2e-3), 0.0, 1e-15);
    EXPECT_NEAR(radial_energy(wires, 2e-3), 0.0, 1e-20);
}

// Central differences: their error falls by four when the step is halved. The last two radii lie
// beyond that at which the torsion goes on along its tangent, where the force is linear and the
// difference exact but for rounding.
TEST(RadialForce, IsMinusTheSlopeOfTheEnergy)
{
    for (const double radius : {0.35e-3, 1.2e-3, 1.9e-3, 2.05e-3}) {
        const auto error = [&](double step) {
            const double slope =
                (radial_energy(wires, radius + step) - radial_energy(wires, radius - step)) /
                (2.0 * step);
            return std::abs(slope + radial_force(wires, radius));
        };
        EXPECT_NEAR(std::log2(error(2e-5) / error(1e-5)), 2.0, 0.1) << radius;
    }
    for (const double radius : {1.1 * last_radius, 2.0 * last_radius}) {
        const double step = 1e-5;
        const double slope =
            (radial_energy(wires, radius + step) - radial_energy(wires, radius - step)) /
            (2.0 * step);
        EXPECT_NEAR(slope, -radial_force(wires, radius),
                    1e-9 * std::abs(radial_force(wires, radius)))
            << radius;
    }
}

TEST(RadialForce, GoesOnSmoothlyBeyondTheLastRadius)
{
    const double step = 1e-9;
    const double below = radial_force(wires, last_radius - step);
    const double above = radial_force(wires, last_radius + step);
    EXPECT_NEAR((above - below) / (2.0 * step), -radial_stiffness_at(wires, last_radius),
                1e-4 * radial_stiffness_at(wires, last_radius));
    EXPECT_NEAR(radial_stiffness_at(wires, 1.5 * last_radius),
                radial_stiffness_at(wires, last_radius),
                1e-9 * radial_stiffness_at(wires, last_radius));
}

TEST(RadialStiffness, IsTheSlopeOfTheForce)
{
    for (const double radius : {0.35e-3, 1.2e-3, 1.9e-3, 2.05e-3}) {
        const auto error = [&](double step) {
            const double slope =
                (radial_force(wires, radius + step) - radial_force(wires, radius - step)) /
                (2.0 * step);
            return std::abs(slope + radial_stiffness_at(wires, radius));
        };
        EXPECT_NEAR(std::log2(error(2e-5) / error(1e-5)), 2.0, 0.1) << radius;
    }
    // 0.2 + 0.16 / 0.16
    EXPECT_DOUBLE_EQ(radial_stiffness(wires), 1.2);
    EXPECT_NEAR(radial_stiffness_at(wires, 2e-3), 1.2, 1e-12);
}

TEST(Scaled, MultipliesForceAndEnergy)
{
    const RadialSpring twice = scaled(wires, 2.0);
    EXPECT_DOUBLE_EQ(radial_force(twice, 1.3e-3), 2.0 * radial_force(wires, 1.3e-3));
    EXPECT_DOUBLE_EQ(radial_energy(twice, 1.3e-3), 2.0 * radial_energy(wires, 1.3e-3));
}

}  // namespace braidzone
