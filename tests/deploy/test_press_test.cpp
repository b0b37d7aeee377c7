#include "core/error.hpp"
#include "deploy/press_test.hpp"
#include "support/devices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

namespace {

/// A light test: a net of six crossings around, in small steps up to 1.5 mm.
PressOptions light_options()
{
    PressOptions options;
    options.nodes_per_ring = 6;
    options.stroke = 1.5e-3;
    options.step = 0.125e-3;
    return options;
}

std::vector<PressState> pressed(const FlowDiverter& device, const PressOptions& options)
{
    return press(press_network(device, options).network, options);
}

}  // namespace

TEST(Press, BeginsFreeOfForceAndEndsAtTheStroke)
{
    const auto states = pressed(test::wire_pipeline(4e-3, 0.4, 30e-6), light_options());
    ASSERT_EQ(states.size(), 13U);
    EXPECT_EQ(states.front().force, 0.0);
    EXPECT_NEAR(states.back().displacement, 1.5e-3, 1e-12);
    for (std::size_t i = 1; i < states.size(); ++i)
        EXPECT_GT(states[i].force, states[i - 1].force) << i;
}

// At rest the block carries what the head presses, but for the forces left on the nodes.
TEST(Press, IsInBalance)
{
    PressOptions options = light_options();
    options.residual_tolerance = 1e-4;
    for (const PressState& state : pressed(test::pipeline_4x20(), options))
        EXPECT_NEAR(state.notch_force, state.force, 0.01 * state.force + 1e-9);
}

// No friction: what the head does is stored. The trapezoidal rule over steps of 0.125 mm adds some.
TEST(Press, StoresTheWorkOfTheHead)
{
    const auto states = pressed(test::wire_pipeline(4e-3, 0.4, 30e-6), light_options());
    double work = 0.0;
    for (std::size_t i = 1; i < states.size(); ++i) {
        work += 0.5 * (states[i].force + states[i - 1].force) *
                (states[i].displacement - states[i - 1].displacement);
    }
    EXPECT_NEAR(states.back().energy / work, 1.0, 0.02);
}

// Without friction every force is proportional to a common factor of the coefficients.
TEST(Press, IsLinearInACommonFactor)
{
    PressOptions options = light_options();
    options.stroke = 0.5e-3;
    options.residual_tolerance = 1e-4;
    FlowDiverter device = test::pipeline_4x20();
    const double force = pressed(device, options).back().force;
    device.surface_coefficient *= 3.0;
    device.radial_coefficient *= 3.0;
    EXPECT_NEAR(pressed(device, options).back().force / force, 3.0, 0.01);
}

TEST(Press, RefusesADeviceShorterThanTheNotch)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 8e-3;
    try {
        pressed(device, light_options());
        FAIL() << "no InputError";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("does not reach across the notch of 10 mm"));
    }
}

}  // namespace braidzone
