#include "core/error.hpp"
#include "porous/braid_stokes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double um = 1e-6;
constexpr double viscosity = 3.5e-3;

/// A pore of a tube braid of N wires: circumferential diagonal 4 pi R / N, wires at `angle` from
/// the axis.
Rhombus tube_braid_pore(int num_wires, double diameter, double wire_diameter, double angle)
{
    const double width = 2.0 * std::numbers::pi * diameter / num_wires;
    const double height = width / std::tan(angle);
    return measure_rhombus(Vec3(-0.5 * width, 0.5 * height, 0), Vec3(0.5 * width, 0.5 * height, 0),
                           wire_diameter, Vec3::UnitX());
}

/// A pore of two orthogonal rows of wires.
Rhombus square_pore(double spacing, double wire_diameter)
{
    return measure_rhombus(Vec3(spacing, 0, 0), Vec3(0, spacing, 0), wire_diameter, Vec3::UnitX());
}

// Values of the series of Tamada and Fujikawa as tabulated with four decimals.
TEST(RowDrag, MatchesTabulatedSeries)
{
    EXPECT_NEAR(row_drag(0.10), 7.5426, 5e-5);
    EXPECT_NEAR(row_drag(0.176), 11.2430, 5e-5);
    EXPECT_NEAR(row_drag(0.25), 15.8717, 5e-5);
    EXPECT_NEAR(row_drag(0.35), 25.0614, 5e-5);
}

// Wire-resolved Stokes flow through a row; the tolerance is the deviation stated for the formula.
TEST(RowDrag, MatchesWireResolvedFlow)
{
    EXPECT_NEAR(row_drag(0.10), 7.51, 0.01 * 7.51);
    EXPECT_NEAR(row_drag(0.40), 31.46, 0.01 * 31.46);
    EXPECT_NEAR(row_drag(0.50), 52.7, 0.01 * 52.7);
    EXPECT_NEAR(row_drag(0.60), 95.1, 0.05 * 95.1);
    EXPECT_NEAR(row_drag(0.70), 198.3, 0.03 * 198.3);
}

// 9 pi / (2 sqrt 2) = 9.9965.
TEST(RowDrag, ReachesTheLubricationLimit)
{
    for (const double s : {0.6, 0.8, 0.99}) {
        EXPECT_NEAR(row_drag(s) * std::pow(1.0 - s, 2.5), 9.9965, 5e-5);
    }
}

TEST(RowDrag, IsContinuousAndGrows)
{
    const double step = 1e-6;
    for (const double joint : {0.5, 0.6}) {
        EXPECT_NEAR(row_drag(joint - step), row_drag(joint + step), 1e-4 * row_drag(joint));
    }
    for (double s = 0.02; s < 0.97; s += 0.01)
        EXPECT_LT(row_drag(s), row_drag(s + 0.01)) << s;
}

TEST(RowDrag, RefusesSoliditiesOutsideItsRange)
{
    for (const double s : {0.0, -0.1, 1.0, 1.5, std::nan("")}) {
        EXPECT_THROW(row_drag(s), InputError) << s;
    }
    try {
        row_drag(1.5);
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("1.5"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("between 0 and 1"), std::string::npos);
    }
}

TEST(CrossingFactor, IsLimited)
{
    EXPECT_NEAR(crossing_factor(0.176), 1.020 + 1.07 * 0.176 - 1.28 * 0.176 * 0.176, 1e-12);
    EXPECT_EQ(crossing_factor(0.95), 1.0);
    EXPECT_GE(crossing_factor(0.0), 1.0);
    for (double s = 0.0; s < 1.0; s += 0.01)
        EXPECT_LE(crossing_factor(s), 1.25);
}

// Wire-resolved Stokes flow through orthogonal rows in touch, a p / mu. The fit's own deviation is
// 1.5 %, that of the row series 1 %.
TEST(BraidStokesLinear, MatchesWireResolvedCrossingRows)
{
    const double spacing = 180 * um;
    const std::pair<double, double> resolved[] = {{0.10, 16.81}, {0.14, 21.56}, {0.176, 26.3},
                                                  {0.22, 33.0},  {0.30, 48.6},  {0.40, 78.4},
                                                  {0.50, 129.4}};
    for (const auto& [s, drag] : resolved) {
        const double a = braid_stokes_linear(square_pore(spacing, s * spacing), viscosity);
        EXPECT_NEAR(a * spacing / viscosity, drag, 0.02 * drag) << "solidity " << s;
    }
}

// The Pipeline's sizes, 48 wires of 30 and 33 um at the angle of the paper's Table 1 (tangent from
// the axis 1 / t), evaluated by hand from the same formulas to three digits.
TEST(BraidStokesLinear, MatchesTabulatedPipelineSizes)
{
    struct Size {
        double diameter_mm, braid_ratio, a_30, a_33, coverage_30, coverage_33, pores_per_mm2;
    };
    const Size sizes[] = {
        {2.5, 0.54, 647, 714, 0.349, 0.379, 34.6}, {3.0, 0.48, 543, 596, 0.322, 0.351, 27.0},
        {3.5, 0.44, 463, 506, 0.299, 0.326, 21.7}, {4.0, 0.40, 420, 457, 0.285, 0.311, 18.2},
        {4.5, 0.37, 383, 416, 0.272, 0.297, 15.6}, {5.0, 0.35, 346, 374, 0.258, 0.282, 13.3}};
    for (const Size& size : sizes) {
        const double angle = std::atan(1.0 / size.braid_ratio);
        const Rhombus thin = tube_braid_pore(48, 1e-3 * size.diameter_mm, 30 * um, angle);
        const Rhombus thick = tube_braid_pore(48, 1e-3 * size.diameter_mm, 33 * um, angle);
        EXPECT_NEAR(braid_stokes_linear(thin, viscosity), size.a_30, 1.0) << size.diameter_mm;
        EXPECT_NEAR(braid_stokes_linear(thick, viscosity), size.a_33, 1.0) << size.diameter_mm;
        EXPECT_NEAR(thin.metal_coverage, size.coverage_30, 6e-4) << size.diameter_mm;
        EXPECT_NEAR(thick.metal_coverage, size.coverage_33, 6e-4) << size.diameter_mm;
        EXPECT_NEAR(1e-6 * thin.pore_density, size.pores_per_mm2, 0.06) << size.diameter_mm;
    }
}

// The reference cell, 48 wires of 33 um at 4 mm and 69 degrees from the axis: wire-resolved flow
// gives 490 Pa s/m, coverage 0.321 and 19.0 pores a mm^2.
TEST(BraidStokesLinear, ReferenceCellHas490PascalSecondPerMetre)
{
    const Rhombus cell = tube_braid_pore(48, 4e-3, 33 * um, 69.0 * std::numbers::pi / 180.0);
    EXPECT_NEAR(cell.metal_coverage, 0.321, 5e-4);
    EXPECT_NEAR(1e-6 * cell.pore_density, 19.0, 0.05);
    EXPECT_NEAR(braid_stokes_linear(cell, viscosity), 490.0, 0.01 * 490.0);
}

// Two rows far apart are a lower bound of two rows in touch; wire-resolved flow stays within 1.3
// times the bound.
TEST(BraidStokesLinear, StaysAboveTheLowerBoundOfSeparateRows)
{
    for (double s = 0.05; s <= 0.6; s += 0.05) {
        for (const double ratio : {1.0, 1.5}) {
            const double d = 30 * um;
            const Rhombus cell =
                measure_rhombus(Vec3(ratio * d / s, 0, 0), Vec3(0, d / s, 0), d, Vec3::UnitX());
            const double rows = viscosity * (row_drag(cell.solidity_a) / cell.spacing_a +
                                             row_drag(cell.solidity_b) / cell.spacing_b);
            const double a = braid_stokes_linear(cell, viscosity);
            EXPECT_GE(a, rows);
            EXPECT_LE(a, 1.3 * rows);
        }
    }
}

// a = mu / d g(s): doubling all lengths halves a.
TEST(BraidStokesLinear, ScalesWithViscosityOverLength)
{
    const Rhombus one = square_pore(190 * um, 33 * um);
    const Rhombus two = square_pore(380 * um, 66 * um);
    const double a = braid_stokes_linear(one, viscosity);
    EXPECT_NEAR(braid_stokes_linear(two, viscosity), 0.5 * a, 1e-12 * a);
    EXPECT_NEAR(braid_stokes_linear(one, 2.0 * viscosity), 2.0 * a, 1e-12 * a);
}

// b = rho / 2 (0.285 + 1.78 s) by hand for 1060 kg/m^3: 245, 317 and 434.
TEST(BraidStokesQuadratic, MatchesTabulatedValues)
{
    EXPECT_NEAR(braid_stokes_quadratic(square_pore(200 * um, 20 * um), 1060), 245, 0.5);
    EXPECT_NEAR(braid_stokes_quadratic(square_pore(200 * um, 35.2 * um), 1060), 317, 0.5);
    EXPECT_NEAR(braid_stokes_quadratic(square_pore(200 * um, 60 * um), 1060), 434, 0.5);
}

// Wire-resolved flow through the reference cell at 0.2 m/s: 111 Pa. The secant of the quadratic
// part is chosen there; 2 % is the accuracy of the resolved flow.
TEST(BraidStokesQuadratic, MeetsWireResolvedFlowAtReynoldsNumberTwo)
{
    const Rhombus cell = tube_braid_pore(48, 4e-3, 33 * um, 69.0 * std::numbers::pi / 180.0);
    const double v = 0.2;
    const double loss =
        braid_stokes_linear(cell, viscosity) * v + braid_stokes_quadratic(cell, 1060) * v * v;
    EXPECT_NEAR(loss, 111.0, 0.02 * 111.0);
}

}  // namespace
}  // namespace braidzone
