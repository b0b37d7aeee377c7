#include "core/error.hpp"
#include "deploy/device_file.hpp"
#include "deploy/device_library.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace braidzone {
namespace {

/// Sets BRAIDZONE_DEVICES for one test.
class DeviceLibrary : public testing::Test {
protected:
    void SetUp() override { ::unsetenv("BRAIDZONE_DEVICES"); }
    void TearDown() override { ::unsetenv("BRAIDZONE_DEVICES"); }

    FlowDiverter read(const std::string& keys)
    {
        notes_.clear();
        const auto path = folder_.write("case.toml", "[device]\n" + keys);
        const TomlTable root = TomlTable::read_file(path);
        FlowDiverter device = read_device(root.table("device"), notes_);
        root.finish();
        return device;
    }

    std::string message(const std::string& keys)
    {
        try {
            read(keys);
        } catch (const ConfigError& error) {
            const std::string text = error.what();
            const auto at = text.find("case.toml");
            return at == std::string::npos ? text : text.substr(at);
        }
        return "accepted";
    }

    bool noted(const std::string& piece) const
    {
        return std::any_of(notes_.begin(), notes_.end(), [&](const std::string& note) {
            return note.find(piece) != std::string::npos;
        });
    }

    test::TemporaryFolder folder_;
    std::vector<std::string> notes_;
};

TEST_F(DeviceLibrary, GivesThePaperValuesOfA4x20)
{
    const FlowDiverter device =
        read("name = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n");
    EXPECT_EQ(device.name, "pipeline-flex");
    EXPECT_EQ(device.num_wires, 48);
    EXPECT_EQ(device.wire_diameter, 30e-6);
    EXPECT_EQ(device.nominal_diameter, 4e-3);
    EXPECT_EQ(device.nominal_length, 20e-3);
    EXPECT_EQ(device.braid_ratio, 0.40);         // Table 1
    EXPECT_EQ(device.surface_coefficient, 0.6);  // Table 2
    EXPECT_EQ(device.radial_coefficient, 0.1);
    EXPECT_DOUBLE_EQ(device.catheter_diameter, 0.6858e-3);  // 0.027 * 25.4 mm
    EXPECT_EQ(device.force_scale, 61.0);
    EXPECT_TRUE(noted("force_scale = 61 is of low confidence"));
    EXPECT_FALSE(noted("follows from other sizes"));
}

TEST_F(DeviceLibrary, ReproducesTable1AtEachOfItsDiameters)
{
    const std::vector<std::pair<std::string, double>> table = {
        {"2.5", 0.54}, {"3", 0.48}, {"3.5", 0.44}, {"4", 0.40}, {"4.5", 0.37}, {"5", 0.35}};
    for (const auto& [diameter, ratio] : table) {
        const FlowDiverter device = read("name = \"pipeline-flex\"\ndiameter = \"" + diameter +
                                         " mm\"\nlength = \"20 mm\"\n");
        EXPECT_EQ(device.braid_ratio, ratio) << diameter;
    }
}

// t(4.25) = 0.160 + 0.957 / 4.25; c on the line through (4, 0.6) and (5, 0.4), (4, 0.1) and
// (5, 0.08); reference area (20/36 mm) pi D / 24.
TEST_F(DeviceLibrary, FillsInOtherSizesAndSaysSo)
{
    FlowDiverter device =
        read("name = \"pipeline-flex\"\ndiameter = \"4.25 mm\"\nlength = \"20 mm\"\n");
    EXPECT_NEAR(device.braid_ratio, 0.160 + 0.957 / 4.25, 1e-12);
    EXPECT_NEAR(device.surface_coefficient, 0.55, 1e-12);
    EXPECT_NEAR(device.radial_coefficient, 0.095, 1e-12);
    EXPECT_TRUE(noted("surface_coefficient = 0.55"));
    EXPECT_TRUE(noted("braid_ratio"));

    device = read("name = \"pipeline-flex\"\ndiameter = \"3 mm\"\nlength = \"20 mm\"\n");
    EXPECT_NEAR(device.surface_coefficient, 0.8, 1e-12);
    EXPECT_NEAR(device.radial_coefficient, 0.12, 1e-12);
    EXPECT_NEAR(device.reference_node_area, 20e-3 / 36 * std::numbers::pi * 3e-3 / 24, 1e-14);
    EXPECT_FALSE(noted("braid_ratio"));
}

TEST_F(DeviceLibrary, TakesEveryValueFromTheCaseIfGiven)
{
    const FlowDiverter device = read(R"(name = "pipeline-flex"
diameter = "4 mm"
length = "20 mm"
num_wires = 64
wire_diameter = "25 um"
braid_ratio = 0.5
catheter_diameter = "0.5 mm"
surface_coefficient = "1 N/m"
radial_coefficient = "0.2 N/m"
reference_node_area = "0.3 mm^2"
force_scale = 2.0
)");
    EXPECT_EQ(device.num_wires, 64);
    EXPECT_EQ(device.wire_diameter, 25e-6);
    EXPECT_EQ(device.braid_ratio, 0.5);
    EXPECT_EQ(device.catheter_diameter, 0.5e-3);
    EXPECT_EQ(device.surface_coefficient, 1.0);
    EXPECT_EQ(device.radial_coefficient, 0.2);
    EXPECT_EQ(device.reference_node_area, 3e-7);
    EXPECT_EQ(device.force_scale, 2.0);
    EXPECT_TRUE(notes_.empty());
}

TEST_F(DeviceLibrary, RefusesASizeThatIsNotMade)
{
    const std::string size = "diameter = \"4.1 mm\"\nlength = \"20 mm\"\n";
    EXPECT_EQ(message("name = \"pipeline-flex\"\n" + size),
              "case.toml:3: device.diameter = 4.1 mm: pipeline-flex is not made in this size; made "
              "are 2.5, 2.75, 3, 3.25, 3.5, 3.75, 4, 4.25, 4.5, 4.75, 5 mm (any_size = true allows "
              "others)");
    EXPECT_EQ(
        message("name = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"21 mm\"\n"),
        "case.toml:4: device.length = 21 mm: pipeline-flex is not made in this size; made are "
        "10, 12, 14, 16, 18, 20, 25, 30, 35 mm (any_size = true allows others)");
    EXPECT_DOUBLE_EQ(read("name = \"pipeline-flex\"\nany_size = true\n" + size).nominal_diameter,
                     4.1e-3);
}

TEST_F(DeviceLibrary, RefusesAnUnknownDeviceWithTheNearestName)
{
    EXPECT_EQ(message("name = \"pipline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n"),
              "case.toml:2: device.name = \"pipline-flex\" is not in the device library; did you "
              "mean \"pipeline-flex\"?");
}

TEST_F(DeviceLibrary, ListsWhatAnIncompleteDeviceLacks)
{
    EXPECT_EQ(message("name = \"p64\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n"),
              "case.toml:2: device.name: device p64 is incomplete; with forces = \"wire-theory\" "
              "these keys must be given in [device]: wire_diameter, braid_ratio, youngs_modulus");
    EXPECT_EQ(message("name = \"p64\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n"
                      "forces = \"springs\"\n"),
              "case.toml:2: device.name: device p64 is incomplete; with forces = \"springs\" these "
              "keys must be given in [device]: wire_diameter, braid_ratio, surface_coefficient, "
              "radial_coefficient, reference_node_area, force_scale");
    const FlowDiverter device = read(R"(name = "p64"
diameter = "4 mm"
length = "20 mm"
wire_diameter = "30 um"
braid_ratio = 0.5
surface_coefficient = "0.6 N/m"
radial_coefficient = "0.1 N/m"
reference_node_area = "0.29 mm^2"
force_scale = 1.0
)");
    EXPECT_EQ(device.num_wires, 64);
}

TEST_F(DeviceLibrary, NeedsNoEntryForADeviceThatTheCaseDescribes)
{
    const std::string complete = R"(diameter = "4.1 mm"
length = "20 mm"
num_wires = 32
wire_diameter = "30 um"
braid_ratio = 0.5
catheter_diameter = "0.5 mm"
surface_coefficient = "0.6 N/m"
radial_coefficient = "0.1 N/m"
reference_node_area = "0.29 mm^2"
force_scale = 1.0
)";
    EXPECT_EQ(read("name = \"prototype\"\n" + complete).name, "prototype");
    EXPECT_EQ(read(complete).name, "custom");
    EXPECT_TRUE(notes_.empty());
}

TEST_F(DeviceLibrary, TakesForcesFromSpringsWhereTheyAreKnown)
{
    const std::string size = "diameter = \"4 mm\"\nlength = \"20 mm\"\n";
    EXPECT_EQ(read("name = \"pipeline-flex\"\n" + size).forces, ForceSource::springs);
    FlowDiverter device = read("name = \"pipeline-flex\"\nforces = \"wire-theory\"\n" + size);
    EXPECT_EQ(device.forces, ForceSource::wire_theory);
    EXPECT_EQ(device.youngs_modulus, 200e9);
    EXPECT_EQ(device.poisson_ratio, 0.3);
    EXPECT_FALSE(noted("force_scale"));  // it does not count
    device = read("name = \"surpass-streamline\"\n" + size);
    EXPECT_EQ(device.forces, ForceSource::wire_theory);
    EXPECT_EQ(device.surface_coefficient, 0.0);
    EXPECT_EQ(message("name = \"pipeline-flex\"\nforces = \"magic\"\n" + size),
              "case.toml:3: device.forces = \"magic\" is not known; allowed are springs, "
              "wire-theory");
}

TEST_F(DeviceLibrary, NeedsNoEntryForABraidThatIsKnownByItsWires)
{
    const FlowDiverter device = read(R"(name = "prototype"
diameter = "4 mm"
length = "20 mm"
num_wires = 48
wire_diameter = "30 um"
nominal_porosity = 0.7152
catheter_diameter = "0.5 mm"
youngs_modulus = "58 GPa"
poisson_ratio = 0.33
distal_flare = "0.1 mm"
proximal_flare = "-0.2 mm"
flare_length = "2 mm"
)");
    EXPECT_EQ(device.forces, ForceSource::wire_theory);
    EXPECT_EQ(device.youngs_modulus, 58e9);
    EXPECT_EQ(device.poisson_ratio, 0.33);
    EXPECT_EQ(device.distal_flare, 0.1e-3);
    EXPECT_EQ(device.proximal_flare, -0.2e-3);
    EXPECT_EQ(device.flare_length, 2e-3);
    // f = 48 * 30 um / (2 pi 4 mm sin b) with tan b = 0.4 is 0.15427, (1 - f)^2 = 0.71526.
    EXPECT_NEAR(device.braid_ratio, 0.40, 2e-4);
}

// Surpass at 4 mm: f = 1 - sqrt(0.7) = 0.163340, sin b = 72 * 28 um / (2 pi 4 mm f) = 0.491086.
TEST_F(DeviceLibrary, FindsTheBraidRatioFromThePorosity)
{
    const std::string size = "diameter = \"4 mm\"\nlength = \"20 mm\"\n";
    const FlowDiverter device = read("name = \"surpass-streamline\"\n" + size);
    EXPECT_NEAR(device.braid_ratio, std::tan(std::asin(0.491086)), 1e-5);
    EXPECT_EQ(read("name = \"surpass-streamline\"\nbraid_ratio = 0.5\n" + size).braid_ratio, 0.5);
    EXPECT_NEAR(read("name = \"pipeline-flex\"\nnominal_porosity = 0.7152\n" + size).braid_ratio,
                0.40, 2e-4);
    EXPECT_EQ(
        message("name = \"pipeline-flex\"\nnominal_porosity = 0.7\nbraid_ratio = 0.4\n" + size),
        "case.toml:3: device.nominal_porosity stands beside braid_ratio, which follows from "
        "it: keep one of them");
}

TEST_F(DeviceLibrary, ListsWhichSourceOfForcesADeviceHas)
{
    for (const DeviceModel& model : device_library()) {
        if (model.name == "pipeline-flex") {
            EXPECT_EQ(model.force_sources,
                      (std::vector{ForceSource::springs, ForceSource::wire_theory}));
        } else if (model.name == "surpass-streamline" || model.name == "pipeline-vantage" ||
                   model.name == "silk-plus") {
            EXPECT_EQ(model.force_sources, std::vector{ForceSource::wire_theory}) << model.name;
        } else {
            EXPECT_FALSE(model.complete) << model.name;
        }
    }
}

TEST_F(DeviceLibrary, NamesThePlaceOfAValueThatIsNoBraid)
{
    EXPECT_EQ(message("name = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n"
                      "wire_diameter = \"1.2 mm\"\n"),
              "case.toml:5: device.wire_diameter = 1200 um exceeds device.diameter / 10 = 400 um");
}

// On the line through 0.6 N/m at 4 mm and 0.4 N/m at 5 mm: -0.2 N/m at 8 mm.
TEST_F(DeviceLibrary, SaysThatAnImpossibleValueIsNotTheUsers)
{
    EXPECT_EQ(message("name = \"pipeline-flex\"\ndiameter = \"8 mm\"\nlength = \"20 mm\"\n"
                      "any_size = true\n"),
              "case.toml:1: device.surface_coefficient = -0.2 N/m is not positive (as it follows "
              "from other "
              "sizes for 8 mm; give it in [device] or state forces = \"wire-theory\")");
}

TEST_F(DeviceLibrary, StatesSourceAndConfidenceOfEveryValue)
{
    const auto models = device_library();
    ASSERT_GE(models.size(), 10u);
    for (const DeviceModel& model : models) {
        EXPECT_FALSE(model.values.empty()) << model.name;
        for (const SourcedValue& value : model.values) {
            EXPECT_FALSE(value.source.empty()) << model.name << "." << value.name;
            EXPECT_FALSE(value.value.empty()) << model.name << "." << value.name;
        }
        EXPECT_EQ(model.name + ".toml", model.file.filename().string());
        EXPECT_EQ(model.complete, model.missing.empty());
    }
    const auto pipeline = std::find_if(models.begin(), models.end(), [](const DeviceModel& model) {
        return model.name == "pipeline-flex";
    });
    ASSERT_NE(pipeline, models.end());
    EXPECT_TRUE(pipeline->complete);
    EXPECT_EQ(pipeline->nominal_diameters.size(), 11u);
    EXPECT_EQ(pipeline->nominal_lengths.size(), 9u);
}

constexpr auto user_device = R"(name = "test-braid"
title = "A braid"
num_wires = { value = [48, 64], at_diameter = ["2 mm", "4 mm"], between = "step", source = "s", confidence = "high" }
wire_diameter = { value = "30 um", source = "s", confidence = "high" }
braid_ratio = { value = [0.5, 0.4, 0.3], at_diameter = ["2 mm", "3 mm", "5 mm"], source = "s", confidence = "high" }
catheter_diameter = { value = "0.5 mm", source = "s", confidence = "high" }
surface_coefficient = { value = "0.6 N/m", source = "s", confidence = "high" }
radial_coefficient = { value = "0.1 N/m", source = "s", confidence = "high" }
reference_node_area = { value = "0.3 mm^2", source = "s", confidence = "high" }
force_scale = { value = 1, source = "s", confidence = "high" }
)";

TEST_F(DeviceLibrary, ReadsTheUsersFolders)
{
    folder_.write("devices/test-braid.toml", user_device);
    ::setenv("BRAIDZONE_DEVICES", (folder_.path() / "devices").c_str(), 1);
    const std::string head = "name = \"test-braid\"\nlength = \"20 mm\"\ndiameter = ";
    EXPECT_EQ(read(head + "\"3.9 mm\"\n").num_wires, 48);
    EXPECT_EQ(read(head + "\"4 mm\"\n").num_wires, 64);
    EXPECT_NEAR(read(head + "\"4 mm\"\n").braid_ratio, 0.35, 1e-12);  // between 0.4 and 0.3
    EXPECT_NEAR(read(head + "\"2.5 mm\"\n").braid_ratio, 0.45, 1e-12);
    EXPECT_NEAR(read(head + "\"6 mm\"\n").braid_ratio, 0.25, 1e-12);  // last line goes on
    EXPECT_EQ(read(head + "\"3 mm\"\n").braid_ratio, 0.4);
}

TEST_F(DeviceLibrary, LetsTheUsersFileWin)
{
    std::string text = user_device;
    text.replace(text.find("test-braid"), 10, "pipeline-flex");
    folder_.write("devices/mine.toml", text);
    ::setenv("BRAIDZONE_DEVICES", (folder_.path() / "devices").c_str(), 1);
    EXPECT_EQ(read("name = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n").num_wires,
              64);
}

TEST_F(DeviceLibrary, RefusesAFolderThatIsNotThere)
{
    ::setenv("BRAIDZONE_DEVICES", (folder_.path() / "absent").c_str(), 1);
    EXPECT_THROW(device_library(), IoError);
}

TEST_F(DeviceLibrary, RefusesAFileThatIsNoDevice)
{
    const std::vector<std::pair<std::string, std::string>> changes = {
        {"confidence = \"high\" }\nwire", "confidence = \"sure\" }\nwire"},
        {"[\"2 mm\", \"4 mm\"]", "[\"2 mm\"]"},
        {"[\"2 mm\", \"3 mm\", \"5 mm\"]", "[\"2 mm\", \"5 mm\", \"3 mm\"]"},
        {"between = \"step\"", "between = \"stairs\""},
        {"title", "tilte"},
        {"wire_diameter = { value = \"30 um\", source = \"s\",",
         "wire_diameter = { value = \"30 um\","},
    };
    for (const auto& [old_text, new_text] : changes) {
        std::string text = user_device;
        const auto at = text.find(old_text);
        ASSERT_NE(at, std::string::npos) << old_text;
        text.replace(at, old_text.size(), new_text);
        EXPECT_THROW(read_device_file(folder_.write("broken.toml", text)), ConfigError) << new_text;
    }
    EXPECT_NO_THROW(read_device_file(folder_.write("sound.toml", user_device)));
}

}  // namespace
}  // namespace braidzone
