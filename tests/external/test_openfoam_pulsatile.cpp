// A sheet of braid across a channel of one cell's cross-section with slip walls, under a pulsatile
// flow rate: a one-dimensional problem with a closed form.

#include "export/foam_apply.hpp"
#include "external/foam_box_case.hpp"
#include "external/openfoam.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace braidzone {
namespace {

constexpr double cell = 0.1e-3;  // [m]
constexpr int along = 60;
constexpr double length = along * cell;
constexpr double one = 0.1 / 1.07;  // period [s]; its twentieth has no short name
const Fluid blood;

/// 0.1 m/s and half of it up and down: not symmetric in time, and as a table.
FlowWaveform waveform()
{
    FlowWaveform wave;
    const int points = 80;
    for (int i = 0; i <= points; ++i) {
        const double phase = 2.0 * std::numbers::pi * (i % points) / points;
        wave.times.push_back(one * i / points);
        wave.flow_rates.push_back(0.1 * (1.0 + 0.4 * std::sin(phase) + 0.1 * std::cos(2 * phase)) *
                                  cell * cell);
    }
    return wave;
}

/// Velocity and its rate at a time, from the formula that the table was made of.
std::pair<double, double> motion(double time)
{
    const double omega = 2.0 * std::numbers::pi / one, phase = omega * time;
    return {0.1 * (1.0 + 0.4 * std::sin(phase) + 0.1 * std::cos(2 * phase)),
            0.1 * omega * (0.4 * std::cos(phase) - 0.2 * std::sin(2 * phase))};
}

void write_channel(const std::filesystem::path& folder, int cycles)
{
    FoamFlow flow;
    flow.waveform = waveform();
    flow.cycles = cycles;
    FoamOpening inlet{.name = "inlet", .area = cell * cell},
        outlet{.name = "outlet", .area = cell * cell};
    test::write_box_case(folder, test::foam_box({along, 1, 1}, cell), {inlet, outlet}, flow, blood);
    test::let_slip(folder);
    // Eight cells across, in the middle of the channel and off the cells' centres and faces.
    apply_to_foam_case(folder,
                       test::flat_sheet(0, Vec3(0.5 * length + 0.23 * cell, 0, 0), cell, cell),
                       {.deposit = {.kernel_half_width = 4.0}});
}

struct Sample {
    double time = 0.0;
    double pressure = 0.0;  ///< [Pa]
};

/// The pressure at the inlet.
std::vector<Sample> inlet_pressure(const std::filesystem::path& folder)
{
    std::vector<Sample> samples;
    std::istringstream lines(test::file_text(test::table_of(folder, "inletPressure")));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        Sample sample;
        if (words >> sample.time >> sample.pressure) {
            sample.pressure *= blood.density;
            samples.push_back(sample);
        }
    }
    return samples;
}

class OpenFoamPulsatile : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (!test::has_openfoam()) GTEST_SKIP() << "pimpleFoam is not installed";
    }
    test::TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path();
};

// dp = a U + b U^2 + rho L dU/dt, L the distance from the inlet to the outlet. Over the cycle it
// goes from 20 to 90 Pa. The layer costs 1 to 2 % as in steady flow, the time steps the rest.
TEST_F(OpenFoamPulsatile, PressureDropIsThatOfTheClosedForm)
{
    write_channel(folder_, 2);
    ASSERT_TRUE(test::allrun(folder_, ""));
    double squares = 0.0, largest = 0.0, mean = 0.0, expected_mean = 0.0, last = 0.0;
    int count = 0;
    for (const Sample& sample : inlet_pressure(folder_)) {
        last = sample.time;
        if (sample.time < one) continue;
        const auto [u, rate] = motion(sample.time);
        const double expected = 490.0 * u + 330.0 * u * u + blood.density * length * rate;
        squares += std::pow(sample.pressure - expected, 2);
        largest = std::max(largest, std::abs(expected));
        mean += sample.pressure;
        expected_mean += expected;
        ++count;
    }
    EXPECT_NEAR(last, 2.0 * one, 1e-7);  // times are named with eight digits
    ASSERT_GE(count, 200);
    const double deviation = std::sqrt(squares / count);
    std::printf("%d steps; deviation %.3g Pa of %.3g Pa; mean %.6g Pa for %.6g Pa\n", count,
                deviation, largest, mean / count, expected_mean / count);
    EXPECT_LT(deviation, 0.02 * largest);
    EXPECT_NEAR(mean / expected_mean, 1.0, 0.02);
}

}  // namespace
}  // namespace braidzone
