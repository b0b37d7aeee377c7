#include "core/error.hpp"
#include "porous/pressure_bench.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

/// The reference cell: 48 wires of 33 um, 4 mm, 69 degrees from the axis.
PressureBench reference()
{
    PressureBench bench;
    bench.device.num_wires = 48;
    bench.device.wire_diameter = 33e-6;
    bench.device.nominal_diameter = bench.diameter = 4e-3;
    bench.device.nominal_length = 20e-3;
    bench.device.braid_ratio = std::tan(21.0 * std::numbers::pi / 180.0);
    bench.fluid = {1060.0, 3.5e-3};
    return bench;
}

}  // namespace

// Wire-resolved flow through the reference cell: coverage 0.321, 4.90 Pa at 0.01 m/s, 111 Pa at
// 0.2 m/s (docs of the braid-stokes law).
TEST(PressureBench, MeetsWireResolvedFlow)
{
    EXPECT_NEAR(bench_rhombus(reference()).metal_coverage, 0.321, 0.001);
    EXPECT_NEAR(bench_pressure_drop(reference(), 0.01), 4.90, 0.1);
    EXPECT_NEAR(bench_pressure_drop(reference(), 0.2), 111.0, 2.5);
}

// Rings closer by a fifth: as many pores more a unit area.
TEST(PressureBench, DensityIncreaseIsThatOfThePores)
{
    PressureBench dense = reference();
    dense.density_increase = 0.2;
    EXPECT_NEAR(bench_rhombus(dense).pore_density, 1.2 * bench_rhombus(reference()).pore_density,
                1.0);
}

// Wires keep their length: half an edge's square is that around plus that along, at any diameter.
TEST(PressureBench, WiresKeepTheirLengthAtAnotherDiameter)
{
    PressureBench narrow = reference();
    narrow.diameter = 3.6e-3;
    EXPECT_NEAR(bench_rhombus(narrow).edge_a.norm(), bench_rhombus(reference()).edge_a.norm(),
                1e-12);
}

TEST(PressureBench, ASecondLayerAddsItsLoss)
{
    PressureBench two = reference();
    two.second_layer = 1.1;
    EXPECT_NEAR(bench_pressure_drop(two, 0.1), 2.1 * bench_pressure_drop(reference(), 0.1), 1e-9);
}

// The law's quadratic loss is that of braid-stokes itself: once more of it doubles it.
TEST(PressureBench, AddedInertiaIsInUnitsOfTheLaws)
{
    PressureBench more = reference();
    more.added_inertia = 1.0;
    EXPECT_NEAR(bench_loss(more).quadratic, 2.0 * bench_loss(reference()).quadratic, 1e-9);
    EXPECT_DOUBLE_EQ(bench_loss(more).linear, bench_loss(reference()).linear);
    more.added_inertia = -1.1;
    EXPECT_THROW(bench_loss(more), InputError);
}

// A slit of 0.3 mm: a = 3.5e-3 (32 / (pi 3e-4) + 12 * 66e-6 / 9e-8) = 149.6 Pa s/m. For slow flow,
// v / ((1 - g) / a_braid + g / a) with g = 4 * 0.3 / 4 = 0.3, by hand.
TEST(PressureBench, AWideGapLowersTheDrop)
{
    PressureBench leaking = reference();
    leaking.channel_diameter = 4e-3;
    leaking.gap_width = 0.3e-3;
    const double tight = bench_pressure_drop(reference(), 1e-5) / 1e-5;
    EXPECT_NEAR(bench_pressure_drop(leaking, 1e-5) / 1e-5, 1.0 / (0.7 / tight + 0.3 / 149.6), 0.1);
    EXPECT_LT(bench_pressure_drop(leaking, 0.1), 0.9 * bench_pressure_drop(reference(), 0.1));
}

// Between wires 0.19 mm apart flow passes more easily than through a slit of half of that.
TEST(PressureBench, ANarrowGapLetsNoMoreThroughThanTheBraid)
{
    PressureBench leaking = reference();
    leaking.channel_diameter = 4e-3;
    leaking.gap_width = 0.09e-3;
    EXPECT_GT(bench_pressure_drop(leaking, 0.1), bench_pressure_drop(reference(), 0.1));
}

}  // namespace braidzone
