#include "core/error.hpp"
#include "porous/rhombus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double um = 1e-6;

// Square mesh of 200 um, wires of 40 um: s = 0.2 each, coverage 0.2 + 0.2 - 0.04, one pore in
// 0.04 mm^2, 400 um of wire of pi/4 (40 um)^2. The wires cross at 90 degrees, so either stands at
// 45 degrees to the diagonal.
TEST(MeasureRhombus, SquareMeshMatchesHandCalculation)
{
    const Rhombus cell =
        measure_rhombus(Vec3(200 * um, 0, 0), Vec3(0, 200 * um, 0), 40 * um, Vec3(1, 1, 0));
    EXPECT_NEAR(cell.area, 4e-8, 1e-20);
    EXPECT_NEAR(cell.spacing_a, 200 * um, 1e-12);
    EXPECT_NEAR(cell.solidity_a, 0.2, 1e-12);
    EXPECT_NEAR(cell.solidity_b, 0.2, 1e-12);
    EXPECT_NEAR(cell.metal_coverage, 0.36, 1e-12);
    EXPECT_NEAR(cell.pore_density, 2.5e7, 1e-3);
    EXPECT_NEAR(cell.wire_length, 400 * um, 1e-12);
    EXPECT_NEAR(cell.metal_volume, 5.026548e-13, 1e-18);
    EXPECT_NEAR(cell.braid_angle, 0.25 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(cell.crossing_angle, 0.5 * std::numbers::pi, 1e-12);
    // A square pore of 160 um: circle and hydraulic diameter are its side.
    EXPECT_NEAR(cell.pore_area, 2.56e-8, 1e-20);
    EXPECT_NEAR(cell.inscribed_diameter, 160 * um, 1e-12);
    EXPECT_NEAR(cell.hydraulic_diameter, 160 * um, 1e-12);
    EXPECT_NEAR(surface_porosity(cell), 0.64, 1e-12);
    EXPECT_NEAR(mean_solidity(cell), 0.2, 1e-12);
    EXPECT_NEAR(wire_length_per_area(cell), 1e4, 1e-6);
    EXPECT_NEAR(metal_volume_per_area(cell), 1.256637e-5, 1e-11);
    // 1 - 12.566 um of metal in a layer of 80 um.
    EXPECT_NEAR(layer_void_fraction(cell), 0.8429204, 1e-7);
    // Wires 200 um long between crossings touch at sin(th) = 40 / 200.
    EXPECT_NEAR(cell.jamming_angle, 0.2013579, 1e-7);
}

// Reference values of a Pipeline's cell (48 wires of 33 um, 4 mm, 69 degrees from the axis): edge
// 280 um, spacing 187.6 um, s = 0.1759, coverage 0.321, 19.0 pores and 10.66 mm of wire a mm^2, 9.1
// um of metal, void fraction of a layer of two diameters 0.862.
TEST(MeasureRhombus, GivesTheReferenceCell)
{
    const double alpha = 69.0 * std::numbers::pi / 180.0;
    const double edge = 280.4 * um;
    const Rhombus cell =
        measure_rhombus(edge * Vec3(std::sin(alpha), std::cos(alpha), 0),
                        edge * Vec3(-std::sin(alpha), std::cos(alpha), 0), 33 * um, Vec3::UnitX());
    EXPECT_NEAR(cell.spacing_a, 187.6 * um, 0.1 * um);
    EXPECT_NEAR(cell.solidity_a, 0.1759, 1e-4);
    EXPECT_NEAR(cell.metal_coverage, 0.321, 1e-3);
    EXPECT_NEAR(cell.pore_density, 19.0e6, 0.05e6);
    EXPECT_NEAR(wire_length_per_area(cell), 1.066e4, 10.0);
    EXPECT_NEAR(metal_volume_per_area(cell), 9.1 * um, 0.05 * um);
    EXPECT_NEAR(layer_void_fraction(cell), 0.862, 1e-3);
    EXPECT_NEAR(cell.crossing_angle, 42.0 * std::numbers::pi / 180.0, 1e-12);
}

// With the edges kept and the crossing angle closed to the jamming angle, the wires touch.
TEST(MeasureRhombus, JamsAtItsJammingAngle)
{
    const auto crossed_at = [](double angle) {
        return measure_rhombus(Vec3(280 * um, 0, 0),
                               350 * um * Vec3(std::cos(angle), std::sin(angle), 0), 30 * um,
                               Vec3::UnitX());
    };
    const double jamming = crossed_at(1.0).jamming_angle;
    EXPECT_NEAR(densest_solidity(crossed_at(jamming)), 1.0, 1e-12);
    EXPECT_LT(densest_solidity(crossed_at(1.01 * jamming)), 1.0);
}

// The open pore is a parallelogram whose sides are shortened by the other wire's width across,
// d / sin(crossing angle): an independent way to the coverage, also for unequal sides.
TEST(MeasureRhombus, CoverageIsOneMinusTheOpenPore)
{
    const double crossing = 50.0 * std::numbers::pi / 180.0, d = 30 * um;
    const double length_a = 280 * um, length_b = 350 * um;
    const Vec3 edge_a = length_a * Vec3::UnitX();
    const Vec3 edge_b = length_b * Vec3(std::cos(crossing), 0, std::sin(crossing));
    const double across = d / std::sin(crossing);
    const double pore = (length_a - across) * (length_b - across) * std::sin(crossing);
    const double cell_area = length_a * length_b * std::sin(crossing);

    const Rhombus cell = measure_rhombus(edge_a, edge_b, d, edge_b - edge_a);
    EXPECT_NEAR(1.0 - cell.metal_coverage, pore / cell_area, 1e-12);
    EXPECT_NEAR(cell.pore_area / pore, 1.0, 1e-12);
    const double perimeter = 2.0 * (length_a + length_b - 2.0 * across);
    EXPECT_NEAR(cell.hydraulic_diameter / (4.0 * pore / perimeter), 1.0, 1e-12);
    // The wires and the diagonal between their ends form a triangle with angles adding to pi.
    EXPECT_NEAR(cell.braid_angle, 0.5 * (std::numbers::pi - crossing), 1e-12);
}

// Doubling all lengths keeps coverage and angle, quarters the pore density.
TEST(MeasureRhombus, ScalesWithLength)
{
    const Vec3 a(260 * um, 100 * um, 20 * um), b(-240 * um, 120 * um, 0), around(1, 0, 0);
    const Rhombus one = measure_rhombus(a, b, 30 * um, around);
    const Rhombus two = measure_rhombus(2 * a, 2 * b, 60 * um, around);
    EXPECT_NEAR(two.metal_coverage, one.metal_coverage, 1e-12);
    EXPECT_NEAR(two.braid_angle, one.braid_angle, 1e-12);
    EXPECT_NEAR(two.pore_density, 0.25 * one.pore_density, 1e-6 * one.pore_density);
    EXPECT_NEAR(two.metal_volume, 8.0 * one.metal_volume, 1e-12 * one.metal_volume);
}

TEST(MeasureRhombus, TouchingWiresCoverEverything)
{
    const Rhombus cell =
        measure_rhombus(Vec3(100 * um, 0, 0), Vec3(0, 30 * um, 0), 30 * um, Vec3::UnitX());
    EXPECT_EQ(cell.metal_coverage, 1.0);
    EXPECT_EQ(cell.pore_area, 0.0);
    EXPECT_EQ(cell.inscribed_diameter, 0.0);
    EXPECT_EQ(cell.hydraulic_diameter, 0.0);
}

TEST(MeasureRhombus, RefusesCellsWithoutArea)
{
    const Vec3 edge(100 * um, 20 * um, 0);
    EXPECT_THROW(measure_rhombus(edge, 2.0 * edge, 30 * um, Vec3::UnitX()), InputError);
    EXPECT_THROW(measure_rhombus(edge, Vec3::Zero(), 30 * um, Vec3::UnitX()), InputError);
    EXPECT_THROW(measure_rhombus(edge, Vec3(0, std::nan(""), 0), 30 * um, Vec3::UnitX()),
                 InputError);
    try {
        measure_rhombus(edge, edge, 30 * um, Vec3::UnitX());
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("without area"), std::string::npos);
    }
}

TEST(MeasureRhombus, RefusesWiresWithoutThickness)
{
    EXPECT_THROW(measure_rhombus(Vec3::UnitX(), Vec3::UnitY(), 0.0, Vec3::UnitX()), InputError);
    EXPECT_THROW(measure_rhombus(Vec3::UnitX(), Vec3::UnitY(), std::nan(""), Vec3::UnitX()),
                 InputError);
}

}  // namespace
}  // namespace braidzone
