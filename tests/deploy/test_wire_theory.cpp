#include "core/error.hpp"
#include "deploy/braid_kinematics.hpp"
#include "deploy/wire_theory.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace braidzone {

namespace {

constexpr double mmhg = 133.322387415;  // [Pa]

/// The same braid as `device`, described at the diameter to which it is opened free of force:
/// its wires keep length and turns, and are straightened to be at rest there.
FlowDiverter opened_to(FlowDiverter device, double diameter)
{
    const double cosine = diameter / largest_diameter(device);
    device.braid_ratio = std::sqrt(1.0 - cosine * cosine) / cosine;
    device.nominal_diameter = diameter;
    return device;
}

std::string message(const std::function<void()>& call)
{
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

struct Pressures {
    double wire_diameter, youngs_modulus;
    /// In vessels of 3.0, 3.5, 3.79 and 4.0 mm [mmHg].
    std::vector<double> at_nominal_4, at_nominal_5, at_free_425, at_free_525;
};

// An evaluation of Jedwab and Clerc's equations by another program, to the digits that it printed:
// Pipelines of 4 and 5 mm with the ratios of Zavodszky et al. 2020, Table 1, at rest at their label
// diameter and at rest 0.25 mm above it.
TEST(WirePressure, AgreesWithTabulatedPipelines)
{
    const std::vector<Pressures> table = {{28e-6,
                                           200e9,
                                           {15.8, 11.6, 7.6, 0.0},
                                           {9.6, 8.0, 7.3, 6.8},
                                           {22.6, 21.1, 21.1, 21.3},
                                           {11.9, 10.6, 10.1, 9.9}},
                                          {30e-6,
                                           200e9,
                                           {20.8, 15.3, 10.0, 0.0},
                                           {12.7, 10.6, 9.6, 8.9},
                                           {29.8, 27.9, 27.9, 28.1},
                                           {15.7, 14.0, 13.4, 13.1}},
                                          {33e-6,
                                           220e9,
                                           {33.5, 24.7, 16.0, 0.0},
                                           {20.4, 17.1, 15.5, 14.4},
                                           {48.0, 44.9, 44.9, 45.2},
                                           {25.2, 22.5, 21.5, 21.0}}};
    const std::vector<double> vessels = {3.0e-3, 3.5e-3, 3.79e-3, 4.0e-3};
    for (const Pressures& row : table) {
        FlowDiverter four = test::wire_pipeline(4e-3, 0.40, row.wire_diameter);
        FlowDiverter five = test::wire_pipeline(5e-3, 0.35, row.wire_diameter);
        four.youngs_modulus = five.youngs_modulus = row.youngs_modulus;
        for (std::size_t i = 0; i < vessels.size(); ++i) {
            const double vessel = vessels[i];
            EXPECT_NEAR(wire_pressure(four, vessel) / mmhg, row.at_nominal_4[i], 0.0501);
            EXPECT_NEAR(wire_pressure(five, vessel) / mmhg, row.at_nominal_5[i], 0.0501);
            EXPECT_NEAR(wire_pressure(opened_to(four, 4.25e-3), vessel) / mmhg, row.at_free_425[i],
                        0.0501);
            EXPECT_NEAR(wire_pressure(opened_to(five, 5.25e-3), vessel) / mmhg, row.at_free_525[i],
                        0.0501);
        }
    }
}

// The free length at a diameter by the kinematics of the braid.
double length_at(const FlowDiverter& device, double diameter)
{
    return device.nominal_length *
           length_ratio(device.braid_ratio, diameter / device.nominal_diameter);
}

// Central differences: their error falls by four when the step is halved.
TEST(AxialForce, IsTheSlopeOfTheEnergyOverTheLength)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    for (const double diameter : {0.8e-3, 2.5e-3, 3.8e-3, 4.2e-3}) {
        const auto error = [&](double step) {
            const double low = diameter - step, high = diameter + step;
            const double slope = (wire_energy(device, high) - wire_energy(device, low)) /
                                 (length_at(device, high) - length_at(device, low));
            return std::abs(slope - axial_force(device, diameter));
        };
        const double coarse = error(1e-5), fine = error(5e-6);
        EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << diameter;
        EXPECT_LT(fine, 1e-3 * std::abs(axial_force(device, diameter))) << diameter;
    }
}

TEST(WirePressure, IsTheSlopeOfTheEnergyOverTheVolumeSwept)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    for (const double diameter : {0.8e-3, 2.5e-3, 3.8e-3, 4.2e-3}) {
        const double swept_per_diameter =
            0.5 * std::numbers::pi * diameter * length_at(device, diameter);
        const auto error = [&](double step) {
            const double slope =
                (wire_energy(device, diameter + step) - wire_energy(device, diameter - step)) /
                (2.0 * step);
            return std::abs(-slope / swept_per_diameter - wire_pressure(device, diameter));
        };
        const double coarse = error(1e-5), fine = error(5e-6);
        EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << diameter;
        EXPECT_LT(fine, 1e-3 * std::abs(wire_pressure(device, diameter))) << diameter;
    }
}

TEST(WirePressure, VanishesAtNominalDiameterAndPushesBackOnBothSides)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    EXPECT_NEAR(wire_pressure(device, 4e-3), 0.0, 1e-9 * wire_pressure(device, 3e-3));
    EXPECT_GT(wire_pressure(device, 3.9e-3), 0.0);
    EXPECT_LT(wire_pressure(device, 4.1e-3), 0.0);
    EXPECT_GT(axial_force(device, 3.9e-3), 0.0);
    EXPECT_LT(axial_force(device, 4.1e-3), 0.0);
}

// D -> 0: the wires are stretched out, and what is left is p D = 4 n EI K2 / (pi K3^2), with
// K2 = 2 cos^2 b0 / D0 and K3 = D0 / cos b0. With t = 0.4, cos^2 b0 = 1 / 1.16.
TEST(WirePressure, GrowsAsOneOverTheDiameterInANarrowTube)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    const double bending = 200e9 * std::numbers::pi * std::pow(30e-6, 4) / 64.0;
    const double k2 = 2.0 / 1.16 / 4e-3, k3 = 4e-3 * std::sqrt(1.16);
    const double limit = 4.0 * 48 * bending * k2 / (std::numbers::pi * k3 * k3);
    const auto distance = [&](double diameter) {
        return std::abs(wire_pressure(device, diameter) * diameter / limit - 1.0);
    };
    EXPECT_LT(distance(4e-6), 2e-3);
    EXPECT_NEAR(distance(4e-6) / distance(8e-6), 0.5, 0.01);
}

// D -> K3: the wires lie along the circumference, untwisted, and p tan^2 b -> -4 n GJ K1 / (pi
// K3^3) with K1 = sin 2 b0 / D0, sin 2 b0 = 2 t / (1 + t^2) = 0.8 / 1.16.
TEST(WirePressure, GrowsWithoutBoundWhereTheWiresClose)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    const double torsion = 200e9 / 2.6 * std::numbers::pi * std::pow(30e-6, 4) / 32.0;
    const double k1 = 0.8 / 1.16 / 4e-3, k3 = 4e-3 * std::sqrt(1.16);
    const double limit = -4.0 * 48 * torsion * k1 / (std::numbers::pi * std::pow(k3, 3));
    const auto distance = [&](double sine) {
        const double cosine = std::sqrt(1.0 - sine * sine), tangent = sine / cosine;
        return std::abs(wire_pressure(device, k3 * cosine) * tangent * tangent / limit - 1.0);
    };
    EXPECT_LT(distance(1e-3), 0.01);
    EXPECT_NEAR(distance(1e-3) / distance(2e-3), 0.5, 0.01);
}

TEST(WireRadialForce, IsThePressureOverTheCircumference)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    EXPECT_DOUBLE_EQ(wire_radial_force(device, 3.5e-3),
                     wire_pressure(device, 3.5e-3) * std::numbers::pi * 3.5e-3);
}

// EI = 200 GPa pi (30 um)^4 / 64 = 7.9522e-9 N m^2, GJ = EI / 1.3; l = pi 4 mm / 48 sqrt(1.16)
// = 0.28197 mm: EI / l^3 = 354.7 N/m, EA / l = 141.37 N / 0.28197 mm = 5.0137e5 N/m.
TEST(WireStiffness, MatchesHandCalculation)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    EXPECT_NEAR(wire_bending_rigidity(device), 7.9522e-9, 1e-13);
    EXPECT_NEAR(wire_torsion_rigidity(device), 7.9522e-9 / 1.3, 1e-13);
    EXPECT_NEAR(crossing_bending_stiffness(device), 354.7, 0.1);
    EXPECT_NEAR(wire_axial_stiffness(device), 5.0137e5, 50.0);
    EXPECT_NEAR(largest_diameter(device), 4e-3 * 1.0770330, 1e-9);
    // dL0 = 0.10472 mm, 2 dR0 = 0.523599 mm
    EXPECT_NEAR(crossing_node_area(device), 0.0548311e-6, 1e-12);
}

// Node area at force-free spacing: lambda dL0 2 pi r / (n/2). The spring and the theory are the
// same function there.
TEST(CrossingRadialSpring, GivesThePressureOfTheWholeBraid)
{
    for (const FlowDiverter& device :
         {test::wire_pipeline(4e-3, 0.40), test::wire_pipeline(2.5e-3, 0.54, 25e-6),
          test::wire_pipeline(5e-3, 0.2, 33e-6)}) {
        const RadialSpring spring = crossing_radial_spring(device);
        const double spacing =
            device.braid_ratio * std::numbers::pi * device.nominal_diameter / device.num_wires;
        for (const double ratio : {0.2, 0.5, 0.7, 0.9, 0.99, 1.01}) {
            const double radius = ratio * device.nominal_radius();
            const double area = length_ratio(device.braid_ratio, ratio) * spacing * 2.0 *
                                std::numbers::pi * radius / (device.num_wires / 2);
            const double expected = wire_pressure(device, 2.0 * radius);
            EXPECT_NEAR(radial_force(spring, radius) / area, expected, 1e-9 * std::abs(expected))
                << ratio;
        }
    }
}

TEST(WireTheory, RefusesADiameterThatTheBraidCannotHave)
{
    const FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    const std::string expected =
        "diameter = 4.4 mm; a braid of nominal diameter 4 mm and ratio 0.4 allows more than 0 and "
        "less than 4.30813 mm";
    EXPECT_EQ(message([&] { wire_pressure(device, 4.4e-3); }), expected);
    EXPECT_EQ(message([&] { axial_force(device, 4.4e-3); }), expected);
    EXPECT_EQ(message([&] { wire_energy(device, 4.4e-3); }), expected);
    EXPECT_THROW(wire_pressure(device, 0.0), InputError);
    EXPECT_THROW(wire_radial_force(device, std::numeric_limits<double>::quiet_NaN()), InputError);
}

TEST(WireTheory, RefusesADeviceWithoutModulus)
{
    FlowDiverter device = test::wire_pipeline(4e-3, 0.40);
    device.youngs_modulus = 0.0;
    const std::string expected = "device.youngs_modulus = 0 Pa; wire theory needs a positive one";
    EXPECT_EQ(message([&] { wire_pressure(device, 3e-3); }), expected);
    EXPECT_EQ(message([&] { crossing_radial_spring(device); }), expected);
    EXPECT_EQ(message([&] { crossing_bending_stiffness(device); }), expected);
    EXPECT_EQ(message([&] { wire_axial_stiffness(device); }), expected);
}

}  // namespace braidzone
