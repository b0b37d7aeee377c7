#include "cli/press_file.hpp"
#include "core/error.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>

namespace braidzone {
namespace {

using testing::HasSubstr;

constexpr auto text = R"([device]
name = "pipeline-flex"
diameter = "4 mm"
length = "20 mm"
[press]
notch_width = "9 mm"
notch_angle = "60 deg"
edge_radius = "0.4 mm"
head = "flat"
head_radius = "1.5 mm"
stroke = "0.5 mm"
step = "0.25 mm"
nodes_per_ring = 6
)";

std::string message_of(const std::string& content)
{
    const test::TemporaryFolder folder;
    try {
        read_press_file(folder.write("press.toml", content));
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "no ConfigError";
}

std::string with(std::string content, const std::string& from, const std::string& to)
{
    return content.replace(content.find(from), from.size(), to);
}

}  // namespace

TEST(PressFile, GivesEveryValueInSi)
{
    const test::TemporaryFolder folder;
    const PressFile press = read_press_file(folder.write("press.toml", text));
    EXPECT_DOUBLE_EQ(press.options.bench.notch_width, 9e-3);
    EXPECT_DOUBLE_EQ(press.options.bench.notch_angle, std::numbers::pi / 3.0);
    EXPECT_DOUBLE_EQ(press.options.bench.edge_radius, 0.4e-3);
    EXPECT_EQ(press.options.bench.head, PressHead::flat);
    EXPECT_DOUBLE_EQ(press.options.bench.head_radius, 1.5e-3);
    EXPECT_DOUBLE_EQ(press.options.stroke, 0.5e-3);
    EXPECT_DOUBLE_EQ(press.options.step, 0.25e-3);
    EXPECT_EQ(press.options.nodes_per_ring, 6);
}

TEST(PressFile, RefusesWhatIsOutOfRange)
{
    EXPECT_THAT(message_of(with(text, "60 deg", "180 deg")), HasSubstr("less than 180"));
    EXPECT_THAT(message_of(with(text, "9 mm", "-9 mm")), HasSubstr("notch_width"));
    EXPECT_THAT(message_of(with(text, "flat", "round")), HasSubstr("\"round\" is not known"));
    EXPECT_THAT(message_of(with(text, "notch_width", "notch_with")), HasSubstr("did you mean"));
}

TEST(PressVerb, WritesTheForceCurve)
{
    const test::TemporaryFolder folder;
    const auto file = folder.write("press.toml", text);
    const auto table = folder.path() / "curve.csv";
    const test::Program press({"press", file.string(), "--output", table.string()}, folder.path());
    ASSERT_EQ(press.wait(), 0) << press.err();
    EXPECT_THAT(press.out(), HasSubstr("force scale 61"));
    std::ifstream lines(table);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "displacement_mm,force_mN,deflection_mm,energy_uJ");
    std::getline(lines, line);
    EXPECT_THAT(line, testing::StartsWith("0,0,0,"));
    int num_states = 1;
    for (; std::getline(lines, line); ++num_states) {
    }
    EXPECT_EQ(num_states, 3);  // 0, 0.25 and 0.5 mm
}

// The measured curve is the program's own for twice the coefficients, at another step: what is
// tested is the way from the files to the written coefficients, not the fit.
TEST(CalibrateVerb, WritesTheCoefficientsOfAMeasuredCurve)
{
    const test::TemporaryFolder folder;
    const std::string device = std::string(text).substr(0, std::string(text).find("[press]"));
    const std::string bench = device +
                              "[press]\nstroke = \"1.5 mm\"\nstep = \"0.25 mm\"\n"
                              "nodes_per_ring = 8\n";
    const auto file = folder.write("press.toml", bench);
    const auto table = folder.path() / "simulated.csv";
    const test::Program press(
        {"press", file.string(), "--output", table.string(), "--set",
         "device.surface_coefficient=1.2 N/m", "--set", "device.radial_coefficient=0.2 N/m"},
        folder.path());
    ASSERT_EQ(press.wait(), 0) << press.err();
    std::ifstream lines(table);
    std::string measured = "displacement_mm,force_mN\n", line;
    std::getline(lines, line);
    while (std::getline(lines, line))
        measured += line.substr(0, line.find(',', line.find(',') + 1)) + "\n";
    const auto curve = folder.write("measured.csv", measured);

    const auto output = folder.path() / "fit.json";
    const test::Program calibrate(
        {"calibrate", file.string(), "--measured", curve.string(), "--output", output.string()},
        folder.path());
    ASSERT_EQ(calibrate.wait(), 0) << calibrate.err();
    EXPECT_THAT(calibrate.out(), HasSubstr("surface_coefficient = \""));
    EXPECT_THAT(calibrate.out(), HasSubstr("force_scale = 1"));
    std::ifstream written(output);
    const nlohmann::json fit = nlohmann::json::parse(written);
    EXPECT_EQ(fit["curve"]["displacement"].size(), 7u);  // 0 to 1.5 mm by 0.25 mm
    EXPECT_DOUBLE_EQ(fit["curve"]["displacement"][6].get<double>(), 1.5e-3);
    EXPECT_EQ(fit["surface_coefficient"]["unit"], "N/m");
    // Real coefficients are those of the paper's code times the device's scale of 61.
    for (const auto& [key, value] :
         {std::pair("surface_coefficient", 1.2 * 61), std::pair("radial_coefficient", 0.2 * 61)}) {
        EXPECT_LE(fit[key]["interval_95"][0].get<double>(), value) << fit.dump(1);
        EXPECT_GE(fit[key]["interval_95"][1].get<double>(), value) << fit.dump(1);
    }

    const test::Program absent({"calibrate", file.string(), "--measured", "absent.csv"},
                               folder.path());
    EXPECT_EQ(absent.wait(), 5);
    EXPECT_THAT(absent.err(), HasSubstr("absent.csv cannot be read"));
}

}  // namespace braidzone
