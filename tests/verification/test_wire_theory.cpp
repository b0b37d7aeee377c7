// Devices with forces from their wires, released at force-free spacing in straight tubes, against
// the closed forms of Jedwab and Clerc (1993) and of a braid of inextensible wires.

#include "deploy/braid_kinematics.hpp"
#include "deploy/deployment.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/device_library.hpp"
#include "deploy/wire_theory.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace braidzone {

namespace {

/// Nominal length over nominal diameter: the rings at the ends, which stand for less than their
/// share of the length, are 2 % of it.
constexpr double length_over_diameter = 2.5;

const ReleaseSchedule force_free{.windows = {}, .table = {}, .table_file = {}, .sliding = 1.0};

/// A device of the library with forces from its wires.
FlowDiverter library_device(const std::string& name, double diameter)
{
    const test::TemporaryFolder folder;
    const auto file = folder.write(
        "case.toml",
        fmt::format("[device]\nname = \"{}\"\ndiameter = \"{} mm\"\nlength = \"{} mm\"\n"
                    "any_size = true\nforces = \"wire-theory\"\n",
                    name, 1e3 * diameter, 1e3 * length_over_diameter * diameter));
    std::vector<std::string> notes;
    return read_device(TomlTable::read_file(file).table("device"), notes);
}

struct Held {
    double diameter = 0.0;  ///< of the nodes' rings [m]
    double implanted_length = 0.0;
    double resting_length = 0.0;
    double radial_force_per_length = 0.0;
    double mean_contact_pressure = 0.0;
    bool converged = false;
};

/// The device held in a tube of a diameter.
Held hold(const FlowDiverter& device, double diameter)
{
    const double ratio = diameter / device.nominal_diameter;
    const double length =
        1.1 * device.nominal_length * length_ratio(device.braid_ratio, ratio) + 2e-3;
    const Vessel vessel = test::tube_vessel(0.5 * diameter, length, 96, 4);
    const WallTree wall(vessel);
    const Deployment deployment = deploy(device, test::tube_centerline(0.5 * diameter, length),
                                         wall, length - 1e-3, force_free);
    const DeploymentMeasures figures = measure(deployment, device, wall, 60e-6);
    return {
        2.0 * figures.mean_radial_expansion, figures.implanted_length,      figures.resting_length,
        figures.radial_force_per_length,     figures.mean_contact_pressure, deployment.converged};
}

}  // namespace

struct LibrarySize {
    std::string name;
    double diameter = 0.0;  ///< [m]
};

void PrintTo(const LibrarySize& size, std::ostream* out)
{
    *out << size.name << " " << 1e3 * size.diameter << " mm";
}

class WiresInTube : public testing::TestWithParam<LibrarySize> {};

// From just below nominal down to the tightest vessel that `deploy` allows, half of it. The theory
// is taken at the diameter at which the nodes are held, 2 um less than the tube's: near nominal
// diameter that is a part of the whole compression.
TEST_P(WiresInTube, BearsThePressureOfTheTheory)
{
    const FlowDiverter device = library_device(GetParam().name, GetParam().diameter);
    for (const double ratio : {0.98, 0.95, 0.9, 0.8, 0.65, 0.51}) {
        const Held held = hold(device, ratio * device.nominal_diameter);
        ASSERT_TRUE(held.converged) << ratio;
        const double pressure = wire_pressure(device, held.diameter);
        const double force = wire_radial_force(device, held.diameter);
        EXPECT_NEAR(held.mean_contact_pressure, pressure, 0.05 * pressure) << ratio;
        EXPECT_NEAR(held.radial_force_per_length, force, 0.05 * force) << ratio;
    }
}

TEST_P(WiresInTube, HasTheLengthOfInextensibleWires)
{
    const FlowDiverter device = library_device(GetParam().name, GetParam().diameter);
    for (const double ratio : {0.98, 0.9, 0.7, 0.51}) {
        const Held held = hold(device, ratio * device.nominal_diameter);
        EXPECT_NEAR(held.implanted_length / held.resting_length,
                    length_ratio(device.braid_ratio, ratio), 0.01)
            << ratio;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Library, WiresInTube,
    testing::Values(LibrarySize{"pipeline-flex", 2.5e-3}, LibrarySize{"pipeline-flex", 4e-3},
                    LibrarySize{"pipeline-flex", 5e-3}, LibrarySize{"pipeline-vantage", 3e-3},
                    LibrarySize{"pipeline-vantage", 4e-3}, LibrarySize{"silk-plus", 3e-3},
                    LibrarySize{"silk-plus", 4e-3}, LibrarySize{"surpass-streamline", 2.5e-3},
                    LibrarySize{"surpass-streamline", 4e-3},
                    LibrarySize{"surpass-streamline", 5e-3}),
    [](const auto& size) {
        std::string name = fmt::format("{}_{:.0f}um", size.param.name, 1e6 * size.param.diameter);
        for (char& letter : name) {
            if (letter == '-') letter = '_';
        }
        return name;
    });

// A device of the library that becomes complete has to be tested above.
TEST(WiresInTube, CoversEveryCompleteDevice)
{
    for (const DeviceModel& model : device_library()) {
        const bool tested = model.name == "pipeline-flex" || model.name == "pipeline-vantage" ||
                            model.name == "silk-plus" || model.name == "surpass-streamline";
        EXPECT_EQ(model.complete, tested) << model.name;
    }
}

// Implanted Pipelines: a radius 6 % below the predicted one went with a length 13 % above it
// (Bouillot et al. 2016, AJNR 37:2079), a slope of -2.2. By the closed form it is
// -(D/D0)^2 / (t^2 + 1 - (D/D0)^2), at 0.9 between -2.1 and -2.3 for 3.5 and 4 mm.
TEST(ForceFreeRelease, LengthensAsImplantedPipelinesDo)
{
    for (const double diameter : {3.5e-3, 4e-3}) {
        const FlowDiverter device = library_device("pipeline-flex", diameter);
        const Held narrow = hold(device, 0.89 * diameter), wide = hold(device, 0.91 * diameter);
        const double slope =
            std::log(wide.implanted_length / narrow.implanted_length) / std::log(0.91 / 0.89);
        const double square = 0.81, t = device.braid_ratio;
        EXPECT_NEAR(slope, -square / (t * t + 1.0 - square), 0.02) << diameter;
        EXPECT_LT(slope, -2.08) << diameter;
        EXPECT_GT(slope, -2.33) << diameter;
    }
}

}  // namespace braidzone
