#include "core/error.hpp"
#include "deploy/calibration.hpp"
#include "support/devices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace braidzone {

namespace {

PressOptions light_options()
{
    PressOptions options;
    options.nodes_per_ring = 8;
    options.stroke = 3e-3;
    options.step = 0.25e-3;
    return options;
}

/// A press test of a device as a tester would measure it: three repeats with noise, of a finer net
/// than that of the fit.
ForceCurve measured(const FlowDiverter& device, double noise, unsigned seed)
{
    PressOptions options = light_options();
    options.nodes_per_ring = 11;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, noise);
    ForceCurve curve;
    curve.num_repeats = 3;
    curve.deviation = noise;
    for (const PressState& state : press(press_network(device, options).network, options)) {
        const double force = state.force + (normal(random) + normal(random) + normal(random)) / 3.0;
        curve.points.push_back({state.displacement, force});
    }
    return curve;
}

}  // namespace

// The fit begins at the paper's coefficients; those of the curve are 1.6 and 0.7 times as large.
TEST(Calibrate, RecoversTheCoefficientsWithinItsIntervals)
{
    FlowDiverter device = test::pipeline_4x20();
    const FlowDiverter start = device;
    device.surface_coefficient *= 1.6;
    device.radial_coefficient *= 0.7;
    int inside = 0;
    for (unsigned seed : {1U, 2U}) {
        const ForceCurve curve = measured(device, 5e-6, seed);
        const Calibration fit = calibrate(start, light_options(), curve);
        SCOPED_TRACE(testing::Message()
                     << "surface " << fit.surface.value << " (" << fit.surface.lower << ", "
                     << fit.surface.upper << ") radial " << fit.radial.value << " ("
                     << fit.radial.lower << ", " << fit.radial.upper << ") chi2 "
                     << fit.reduced_chi_square << " " << fit.statement);
        inside += fit.surface.lower < device.surface_coefficient &&
                  device.surface_coefficient < fit.surface.upper;
        inside += fit.radial.lower < device.radial_coefficient &&
                  device.radial_coefficient < fit.radial.upper;
        EXPECT_NEAR(fit.surface.value / device.surface_coefficient, 1.0, 0.5);
        EXPECT_NEAR(fit.radial.value / device.radial_coefficient, 1.0, 0.5);
        EXPECT_NEAR(fit.fitted_force.back() / curve.points.back().force, 1.0, 0.2);
        EXPECT_EQ(fit.nodes_per_ring, 8);
        EXPECT_EQ(fit.coarse_nodes_per_ring, 6);
    }
    EXPECT_GE(inside, 3);  // of four intervals of 95 %
}

TEST(Calibrate, RefusesANetWithoutACoarserOne)
{
    PressOptions options = light_options();
    options.nodes_per_ring = 7;
    ForceCurve curve;
    curve.points = {{0.0, 0.0}, {1e-3, 1e-3}, {2e-3, 2e-3}, {3e-3, 4e-3}};
    try {
        calibrate(test::pipeline_4x20(), options, curve);
        FAIL() << "no ConfigError";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("nodes_per_ring = 7 is too coarse"));
    }
}

TEST(Calibrate, NeedsADeviceWithSprings)
{
    const FlowDiverter wires = test::wire_pipeline(4e-3, 0.4);
    ForceCurve curve;
    curve.points = {{0.0, 0.0}, {1e-3, 1e-3}, {2e-3, 2e-3}, {3e-3, 4e-3}};
    try {
        calibrate(wires, light_options(), curve);
        FAIL() << "no InputError";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("device.surface_coefficient"));
    }
}

}  // namespace braidzone
