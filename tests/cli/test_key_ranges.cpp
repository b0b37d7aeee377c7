#include "cli/case_file.hpp"
#include "cli/key_ranges.hpp"
#include "cli/press_file.hpp"
#include "cli/pressure_file.hpp"
#include "core/error.hpp"
#include "support/case_texts.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace braidzone {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

/// Reads the smallest case with one key besides.
void read_case_with(const std::string& override_text)
{
    const test::TemporaryFolder folder;
    const auto file = folder.write("case.toml", test::smallest_case);
    read_case(file, {override_text});
}

std::string refusal_of(const std::string& override_text)
{
    try {
        read_case_with(override_text);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

using Tables = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// What must stand beside a key for it to be read, by tables.
const Tables companions = {
    {"vessel.straightening",
     {"share = 0.5", "centre = \"10 mm\"", "half_width = \"2 mm\"", "kept_from = \"1 mm\"",
      "kept_to = \"30 mm\""}},
    {"vessel.openings", {"do = \"keep\""}},
    {"push_pull", {"from = \"8 mm\"", "to = \"12 mm\"", "spacing = 0.5"}},
    {"twist", {"angle = \"10 deg\"", "centre = \"12 mm\"", "half_width = \"2 mm\""}},
    {"incomplete_opening", {"length = \"3 mm\"", "shrink = 0.2"}},
    {"neck", {"from = \"8 mm\"", "to = \"12 mm\""}},
    {"second_device",
     {"name = \"pipeline-flex\"", "diameter = \"4 mm\"", "length = \"20 mm\"",
      "landing_distal = \"18 mm\"", "any_size = true"}},
};

/// The file of some tables with a key set to a value, in place of the line that sets it.
std::string file_with(Tables tables, const std::string& key, const std::string& value)
{
    const std::string table = key.substr(0, key.rfind('.'));
    const std::string leaf = key.substr(key.rfind('.') + 1);
    for (const auto& [name, lines] : companions) {
        if (table.ends_with(name) || (table + ".").starts_with(name + ".")) {
            const bool is_parent = name == "second_device" && table != name;
            tables.emplace_back(is_parent ? name : table, lines);
        }
    }
    auto found = std::find_if(tables.begin(), tables.end(),
                              [&](const auto& each) { return each.first == table; });
    if (found == tables.end()) found = tables.insert(found, {table, {}});
    std::erase_if(found->second,
                  [&](const std::string& line) { return line.starts_with(leaf + " "); });
    found->second.push_back(leaf + " = " + value);
    // Tables before those inside them.
    std::stable_sort(tables.begin(), tables.end(), [](const auto& first, const auto& second) {
        return std::count(first.first.begin(), first.first.end(), '.') <
               std::count(second.first.begin(), second.first.end(), '.');
    });
    std::string text;
    for (const auto& [name, lines] : tables) {
        const bool is_array = name == "export" || name == "vessel.openings" ||
                              name.ends_with("push_pull") || name.ends_with("twist") ||
                              name.ends_with("incomplete_opening");
        text += is_array ? "[[" + name + "]]\n" : "[" + name + "]\n";
        for (const std::string& line : lines)
            text += line + "\n";
    }
    return text;
}

/// Values that no range holds, in the unit in which the range is stated: the first integers that
/// a double does not hold, the largest of 64 bits and the next one, and what overflows in SI.
std::vector<std::string> impossible_values(const KeyRange& range)
{
    const std::size_t space = range.highest.find(' ');
    std::vector<std::string> values;
    for (const std::string number :
         {"9007199254740993", "-9007199254740993", "99999999999999999", "9223372036854775807",
          "9223372036854775808", "1e308", "-1e308"}) {
        values.push_back(space == std::string::npos
                             ? number
                             : "\"" + number + range.highest.substr(space) + "\"");
    }
    return values;
}

template <typename Read>
void expect_refused(const KeyRange& range, const Tables& tables, const Read& read)
{
    const test::TemporaryFolder folder;
    for (const std::string& value : impossible_values(range)) {
        const auto path = folder.write("file.toml", file_with(tables, range.key, value));
        EXPECT_THROW(read(path), ConfigError) << range.key << " = " << value;
    }
}

const Tables device_only = {
    {"device",
     {"name = \"pipeline-flex\"", "diameter = \"4 mm\"", "length = \"20 mm\"", "any_size = true"}}};

// Every numeric key that a file may have, by the list that reading holds it to: a key without a
// range cannot be read at all (`TomlTable::require_ranges`).
TEST(KeyRanges, EveryKeyOfACaseRefusesWhatNoDoubleHolds)
{
    Tables tables = device_only;
    tables.insert(tables.begin(), {"vessel", {"surface = \"vessel.stl\"", "length_unit = \"mm\""}});
    tables.push_back({"deployment", {"landing_distal = \"18 mm\""}});
    for (const KeyRange& range : case_key_ranges()) {
        std::vector<std::string> formats = {"openfoam"};
        if (range.key.starts_with("export.")) formats = {"openfoam", "lattice", "surfaces", "vtk"};
        for (const std::string& format : formats) {
            Tables with_export = tables;
            with_export.push_back({"export", {"format = \"" + format + "\""}});
            expect_refused(range, with_export,
                           [](const std::filesystem::path& path) { read_case(path, {}); });
        }
    }
}

TEST(KeyRanges, EveryKeyOfAPressTestRefusesWhatNoDoubleHolds)
{
    for (const KeyRange& range : press_key_ranges())
        expect_refused(range, device_only,
                       [](const std::filesystem::path& path) { read_press_file(path, {}); });
}

TEST(KeyRanges, EveryKeyOfABenchRefusesWhatNoDoubleHolds)
{
    for (const KeyRange& range : pressure_key_ranges())
        expect_refused(range, device_only,
                       [](const std::filesystem::path& path) { read_pressure_file(path, {}); });
}

// Each plain number of a case: integers that no double holds, and numbers beyond any meaning. A
// number that is taken must be the one that stands there, so all of these must be refused, under
// the key's name.
TEST(KeyRanges, EveryPlainNumberOfACaseKeepsToItsRange)
{
    const std::vector<std::string> keys = {
        "device.num_wires",        "device.nominal_porosity",       "device.braid_ratio",
        "device.force_scale",      "device.poisson_ratio",          "deployment.sliding",
        "deployment.hub_freedom",  "deployment.time_step_ratio",    "deployment.bending_ratio",
        "deployment.num_frames",   "deployment.release_interval",   "deployment.residual_tolerance",
        "porous.tangential_ratio", "deployment.max_settling_steps", "grid.kernel_half_width",
        "measurement.threshold"};
    for (const std::string& key : keys) {
        for (const std::string value :
             {"9007199254740993", "99999999999999999", "9223372036854775807", "-9007199254740993",
              "1e308", "-1e308", "nan", "inf", "9223372036854775808"}) {
            EXPECT_THAT(refusal_of(key + "=" + value),
                        AnyOf(HasSubstr(key.substr(key.find('.') + 1)), HasSubstr("threshold")))
                << value;
        }
    }
}

TEST(KeyRanges, EveryQuantityOfACaseKeepsToItsRange)
{
    const std::vector<std::pair<std::string, std::string>> keys = {
        {"vessel.wall_offset", "mm"},
        {"device.diameter", "mm"},
        {"device.length", "mm"},
        {"device.wire_diameter", "um"},
        {"device.catheter_diameter", "mm"},
        {"device.surface_coefficient", "N/m"},
        {"device.radial_coefficient", "N/m"},
        {"device.reference_node_area", "mm^2"},
        {"device.youngs_modulus", "GPa"},
        {"device.flare_length", "mm"},
        {"deployment.landing_distal", "mm"},
        {"deployment.hub_shift", "mm"},
        {"deployment.wall_stiffness", "Pa/m"},
        {"deployment.damping", "kg/s"},
        {"fluid.density", "kg/m^3"},
        {"fluid.viscosity", "Pa s"},
        {"grid.spacing", "mm"},
        {"measurement.blooming", "mm"}};
    for (const auto& [key, unit] : keys) {
        for (const std::string value : {"1e300", "-1e300", "99999999999999999"}) {
            EXPECT_THAT(refusal_of(key + "=\"" + value + " " + unit + "\""),
                        HasSubstr(key.substr(key.find('.') + 1)))
                << value;
        }
    }
}

// What is far too small to be meant, each with the range in the unit that people write.
TEST(KeyRanges, RefusesWhatIsFarTooSmall)
{
    EXPECT_THAT(refusal_of("grid.spacing=\"0.001 mm\""),
                HasSubstr("grid.spacing = \"0.001 mm\" is out of range; allowed are 0.005 mm to "
                          "20 mm"));
    EXPECT_THAT(refusal_of("device.catheter_diameter=\"1e-6 mm\""),
                HasSubstr("device.catheter_diameter = \"1e-6 mm\" is out of range; allowed are "
                          "0.1 mm to 10 mm"));
    EXPECT_THAT(refusal_of("deployment.wall_stiffness=\"1e-6 Pa/m\""),
                HasSubstr("allowed are 1e5 Pa/m to 1e14 Pa/m"));
    EXPECT_THAT(refusal_of("device.radial_coefficient=\"1e-6 N/m\""),
                HasSubstr("allowed are 1e-4 N/m to 1e4 N/m"));
    EXPECT_THAT(refusal_of("porous.tangential_ratio=0"), HasSubstr("allowed are 0.01 to 10000"));
    EXPECT_THAT(refusal_of("deployment.bending_ratio=1e308"), HasSubstr("allowed are 0 to 1000"));
}

// The ends of a range are allowed, and read as they stand.
TEST(KeyRanges, EndsOfARangeAreAllowed)
{
    EXPECT_EQ(refusal_of("grid.spacing=\"20 mm\""), "accepted");
    EXPECT_EQ(refusal_of("deployment.friction=\"infinite\""), "accepted");
    EXPECT_EQ(refusal_of("deployment.bending_ratio=1000"), "accepted");
    EXPECT_EQ(refusal_of("vessel.wall_offset=\"-5 mm\""), "accepted");
}

TEST(KeyRanges, PointsLieWithinTenMetres)
{
    EXPECT_EQ(refusal_of("deployment.landing_distal=[\"-9 m\", \"0 m\", \"9 m\"]"), "accepted");
    EXPECT_THAT(refusal_of("deployment.landing_distal=[\"-9 m\", \"0 m\", \"11 m\"]"),
                HasSubstr("landing_distal has a coordinate of 11 m"));
}

// A key is declared once, and its range is one.
TEST(KeyRanges, AreDeclaredOnceAndInOrder)
{
    for (const KeyRanges& ranges : {case_key_ranges(), press_key_ranges(), pressure_key_ranges()}) {
        for (const KeyRange& range : ranges) {
            EXPECT_EQ(std::count_if(ranges.begin(), ranges.end(),
                                    [&](const KeyRange& each) { return each.key == range.key; }),
                      1)
                << range.key;
            // Both ends in one unit: comparable as the numbers they begin with, or in mm and m.
            EXPECT_FALSE(range.lowest.empty() || range.highest.empty()) << range.key;
        }
    }
}

}  // namespace
}  // namespace braidzone
