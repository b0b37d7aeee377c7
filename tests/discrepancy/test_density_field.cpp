#include "core/error.hpp"
#include "discrepancy/density_field.hpp"
#include "support/straight_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace braidzone {
namespace {

constexpr double radius = 2e-3, length = 15e-3;
constexpr int num_rings = 76;  // 0.2 mm apart

/// A uniform braid along z; force-free at that radius with rings `spacing_ratio` as far apart.
Simulation straight(double spacing_ratio = 1.0)
{
    Deployment deployment = test::straight_device(radius, length, num_rings);
    deployment.lattice.ring_spacing *= spacing_ratio;
    const auto n = deployment.nodes.size();
    deployment.contact_pressure.assign(n, 0.0);
    deployment.wall_distance.assign(n, 0.0);
    DeviceSurface surface(deployment);
    FlowDiverter device;
    device.wire_diameter = 30e-6;
    return {std::move(deployment), std::move(surface), device};
}

DensityPlace place_at(double x, double z, double value = 1.0)
{
    return {.point = Vec3(x, 0.0, z), .value = value, .sd = 0.1, .line = 2};
}

std::string refusal(const DensityMap& map)
{
    try {
        make_density_field(map, {}, straight());
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace

// A rhombus of the straight braid is half of 2 * 0.2 mm times the chord 2 R sin(pi / 24).
TEST(SimulatedDensity, IsThatOfAUniformBraid)
{
    const double area = 0.2e-3 * 2.0 * radius * std::sin(std::numbers::pi / 24.0);
    DensityMap map{.places = {place_at(radius, 7e-3), place_at(-1.9e-3, 4e-3)}};
    const Simulation simulation = straight();
    const DensityField field = make_density_field(map, {}, simulation);
    for (const double density : simulated_density(field, {}, simulation))
        EXPECT_NEAR(density * area, 1.0, 1e-9);
    // solidities d / p with p = area / edge, edges of half the chord and one ring's spacing
    map.quantity = DensityQuantity::metal_coverage;
    const double edge = std::hypot(0.2e-3, radius * std::sin(std::numbers::pi / 24.0));
    const double solidity = 30e-6 * edge / area;
    // wires on a cylinder bend a little out of their rhombus
    EXPECT_NEAR(simulated_density(make_density_field(map, {}, simulation), {}, simulation)[0],
                solidity * (2.0 - solidity), 5e-3);
}

// Rings at half of the force-free distance hold twice as many pores.
TEST(SimulatedDensity, CountsTheIncreaseFromTheCaseItself)
{
    const DensityMap map{.quantity = DensityQuantity::surface_density_increase,
                         .places = {place_at(radius, 7e-3)}};
    const Simulation dense = straight(2.0);
    const DensityField field = make_density_field(map, {}, dense);
    EXPECT_NEAR(simulated_density(field, {}, dense)[0], 1.0, 1e-9);
    EXPECT_NEAR(field.scale[0], 2.0, 1e-9);
    // Another device supposed: the measured increase still refers to the case's own.
    EXPECT_NEAR(simulated_density(field, {}, straight(3.0))[0], 1.0, 1e-9);
}

// One half of the braid twice as dense as the other: in between a window of 2 mm sees the step as
// its kernel blurs it, the mean at the step; far from it each half's own.
TEST(SimulatedDensity, IsAMeanOverTheWindow)
{
    Simulation simulation = straight();
    Deployment& deployment = simulation.deployment;
    for (int ring = 0; ring < num_rings; ++ring) {
        const double z = deployment.ring_arc_length[static_cast<std::size_t>(ring)];
        const double moved = z > 7.5e-3 ? 7.5e-3 + 0.5 * (z - 7.5e-3) : z;
        for (int column = 0; column < 24; ++column)
            deployment.nodes[static_cast<std::size_t>(ring * 24 + column)].z() = moved;
    }
    simulation.surface = DeviceSurface(deployment);
    DensityMap map{.places = {place_at(radius, 4e-3), place_at(radius, 10e-3)}};
    for (int i = 0; i < 9; ++i)
        map.places.push_back(place_at(radius, 6.5e-3 + i * 0.25e-3));
    for (DensityPlace& place : map.places)
        place.window = 2e-3;
    const DensityField field = make_density_field(map, {}, simulation);
    const Eigen::VectorXd density = simulated_density(field, {}, simulation);
    EXPECT_NEAR(density[1] / density[0], 2.0, 1e-6);
    for (Eigen::Index i = 2; i + 1 < density.size(); ++i)
        EXPECT_LT(density[i], density[i + 1]);
    // Halves of equal area: the mean weighted by area is 1.5 times the lower density.
    EXPECT_NEAR(density[6] / density[0], 1.5, 0.03);
}

TEST(DensityField, FollowsTheFrameOfTheScan)
{
    Imaging imaging;
    imaging.shift = Vec3(0.0, 0.0, 20e-3);
    const DensityMap map{.places = {place_at(radius, -13e-3)}};
    const DensityField field = make_density_field(map, imaging, straight());
    EXPECT_NEAR(field.feet[0].z(), 7e-3, 1e-9);
}

TEST(DensityField, RefusesWhatDoesNotLieOverTheDevice)
{
    EXPECT_THAT(refusal({.places = {place_at(9e-3, 7e-3)}}),
                testing::AllOf(testing::HasSubstr("density map, line 2: the place (9, 0, 7) mm"),
                               testing::HasSubstr("from the simulated device; it must be in the "
                                                  "frame of the measured surface, within 2 mm")));
    EXPECT_THAT(refusal({.places = {place_at(radius, -3e-3), place_at(radius, 19e-3)}}),
                testing::HasSubstr("none of the 2 places of the density map lies over the "
                                   "simulated device, which reaches from 0 to 15 mm"));
    const DensityField field = make_density_field(
        {.places = {place_at(radius, 7e-3), place_at(radius, 19e-3)}}, {}, straight());
    EXPECT_EQ(field.places.size(), 1u);
    EXPECT_EQ(field.num_beyond_ends, 1);
    EXPECT_TRUE(make_density_field({}, {}, straight()).places.empty());
}

// The device ends at 15 mm and is 15 mm long.
TEST(DensityField, RefusesPlacesFarBeyondTheEnds)
{
    EXPECT_THAT(refusal({.places = {place_at(radius, 7e-3), place_at(radius, 31e-3)}}),
                testing::HasSubstr("line 2: the place (2, 0, 31) mm lies"));
}

}  // namespace braidzone
