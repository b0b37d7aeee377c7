// The verb diagnose on bench curves, as a user starts it.

#include "cli/press_file.hpp"
#include "cli/pressure_file.hpp"
#include "core/error.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Ended {
    int status = 0;
    std::string out, err;
};

Ended diagnosed(std::vector<std::string> arguments, const fs::path& folder)
{
    arguments.insert(arguments.begin(), "diagnose");
    const test::Program program(arguments, folder);
    const int status = program.wait();
    return {status, program.out(), program.err()};
}

/// A bench with values of its own, so that nothing depends on the library.
std::string bench_text(const std::string& bench, const std::string& porous = "")
{
    return "[device]\nname = \"braid\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\nnum_wires = 48\n"
           "wire_diameter = \"33 um\"\nbraid_ratio = 0.383864\ncatheter_diameter = \"0.69 mm\"\n"
           "forces = \"wire-theory\"\nyoungs_modulus = \"200 GPa\"\nany_size = true\n"
           "[fluid]\ndensity = \"1060 kg/m^3\"\nviscosity = \"3.5 mPa s\"\n[bench]\n" +
           bench + "[porous]\n" + porous;
}

/// Drops of a v + b v^2 with the reference cell's a = 490 Pa s/m and b = 330 Pa s^2/m^2, times a
/// factor; points are off by 0.3 % by turns.
std::string drops(double factor, double b = 330.0)
{
    std::string text = "velocity_m_s,pressure_drop_Pa\n";
    for (int i = 1; i <= 12; ++i) {
        const double v = 0.03 * i;
        text += fmt::format("{},{}\n", v,
                            factor * (490.0 + b * v) * v * (1.0 + (i % 2 == 0 ? 0.003 : -0.003)));
    }
    return text;
}

nlohmann::json json_in(const fs::path& file)
{
    return nlohmann::json::parse(std::ifstream(file));
}

}  // namespace

TEST(DiagnosePressureDrop, NamesASecondLayerAndWritesABenchWithIt)
{
    const test::TemporaryFolder folder;
    const std::string bench = folder.write("bench.toml", bench_text("")).string();
    const std::string drop = folder.write("drop.csv", drops(2.1)).string();
    const fs::path output = folder.path() / "out";
    const Ended ended =
        diagnosed({bench, "--pressure-drop", drop, "--output", output.string()}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("second_layer: there is a second layer of braid"));
    const auto result = json_in(output / "diagnosis.json");
    EXPECT_EQ(result["answer"]["effects"], nlohmann::json({{"second_layer"}}));
    EXPECT_EQ(result["points"].size(), 12U);
    EXPECT_LT(result["gaps"]["after"].get<double>(), 0.1 * result["gaps"]["before"].get<double>());
    EXPECT_GT(fs::file_size(output / "curve.png"), 1000U);

    // The new bench holds the layer, and nothing is missing in it.
    const fs::path with = output / "case_with_second_layer.toml";
    EXPECT_NEAR(read_pressure_file(with).bench.second_layer, 1.1, 0.1);
    EXPECT_EQ(read_pressure_file(bench).bench.second_layer, 0.0);
    const Ended again = diagnosed(
        {with.string(), "--pressure-drop", drop, "--output", (folder.path() / "again").string()},
        folder.path());
    EXPECT_THAT(again.out, HasSubstr("Nothing is missing"));
}

// The shipped bench, whose measurement was made with a third fewer crossings an area (-0.334).
TEST(DiagnosePressureDrop, NamesTheHiddenDensityOfTheShippedBench)
{
    const test::TemporaryFolder folder;
    const fs::path shipped = fs::path(BRAIDZONE_SOURCE_DIR) / "cases/bench_pressure";
    const fs::path output = folder.path() / "out";
    const Ended ended =
        diagnosed({(shipped / "bench.toml").string(), "--pressure-drop",
                   (shipped / "measured.csv").string(), "--output", output.string()},
                  folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto result = json_in(output / "diagnosis.json");
    EXPECT_EQ(result["answer"]["effects"], nlohmann::json({{"density"}}));
    for (const auto& effect : result["effects"]) {
        if (effect["effect"] != "density") continue;
        const auto& change = effect["parameters"]["density"]["density_change"];
        EXPECT_NEAR(change["value"].get<double>(), -0.334, 2.0 * change["sd"].get<double>());
    }
    std::ifstream file(output / "report.html");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    EXPECT_THAT(page, testing::AllOf(HasSubstr("Simulated and measured pressure drop"),
                                     HasSubstr("density: "), HasSubstr("data:image/png;base64,"),
                                     HasSubstr("<td>149.3</td>"),  // the last point
                                     testing::EndsWith("</html>\n")));
}

// Five benches without an effect, each with a gauge off by a factor of its own. The
// floor that is learned has that factor, and is read back.
TEST(DiagnosePressureDrop, LearnsANoiseFloorAndReadsItBack)
{
    const test::TemporaryFolder folder;
    const std::string bench = folder.write("bench.toml", bench_text("")).string();
    std::vector<std::string> arguments = {bench, "--calibrate"};
    for (const double factor : {0.92, 0.96, 1.0, 1.04, 1.08}) {
        arguments.emplace_back("--pressure-drop");
        arguments.push_back(
            folder.write(fmt::format("drop_{}.csv", factor), drops(factor, 330.0)).string());
    }
    const Ended learned = diagnosed(arguments, folder.path());
    ASSERT_EQ(learned.status, 0) << learned.err;
    const fs::path noise = folder.path() / "bench.noise.json";
    const double scale = json_in(noise)["scale_sd"].get<double>();
    // The deviation of five factors is 0.057, known to a third.
    EXPECT_GT(scale, 0.035);
    EXPECT_LT(scale, 0.08);

    // 12 % too much is an effect by the shipped floor, none by what these benches do.
    const std::string drop = folder.write("drop.csv", drops(1.12)).string();
    const fs::path output = folder.path() / "out";
    const Ended ended = diagnosed(
        {bench, "--pressure-drop", drop, "--noise", noise.string(), "--output", output.string()},
        folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("Nothing is missing"));
    const auto result = json_in(output / "diagnosis.json");
    EXPECT_NEAR(result["noise_floor"]["scale_sd"]["value"].get<double>(), scale, 1e-9);
    EXPECT_EQ(result["inputs"]["noise"]["path"], noise.string());
}

TEST(DiagnosePressureDrop, FindsThatTheLawLacksInertia)
{
    const test::TemporaryFolder folder;
    const std::string bench =
        folder.write("bench.toml", bench_text("", "inertia = false\n")).string();
    const Ended ended =
        diagnosed({bench, "--pressure-drop", folder.write("drop.csv", drops(1.0)).string(),
                   "--output", (folder.path() / "out").string()},
                  folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("missing_inertia: "));
}

TEST(DiagnosePressureDrop, SaysWhichMeasurementWouldTellViscosityFromDensity)
{
    const test::TemporaryFolder folder;
    const std::string bench = folder.write("bench.toml", bench_text("")).string();
    // 1.15 times a, b as it is: drops() times 1.15 with b / 1.15.
    const Ended ended = diagnosed(
        {bench, "--pressure-drop", folder.write("drop.csv", drops(1.15, 330.0 / 1.15)).string(),
         "--output", (folder.path() / "out").string()},
        folder.path());
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("which the data do not tell apart"));
    EXPECT_THAT(ended.out, HasSubstr("viscosity: the fluid's temperature during the run"));
    EXPECT_THAT(ended.out, HasSubstr("density: pore density or implanted length"));
}

TEST(DiagnosePressureDrop, RefusesWhatItCannotUse)
{
    const test::TemporaryFolder folder;
    const std::string good = folder.write("bench.toml", bench_text("")).string();
    const std::string drop = folder.write("drop.csv", drops(1.0)).string();
    const auto refused = [&](const std::vector<std::string>& arguments, int status) {
        const Ended ended = diagnosed(arguments, folder.path());
        EXPECT_EQ(ended.status, status) << ended.err;
        return ended.err;
    };
    EXPECT_THAT(refused({good}, 2), HasSubstr("takes one of --measured, --force-curve and "
                                              "--pressure-drop; 0 are given"));
    EXPECT_THAT(refused({good, "--pressure-drop", drop, "--force-curve", drop}, 2),
                HasSubstr("2 are given"));
    EXPECT_THAT(refused({good, "--pressure-drop", drop, "--scalars", drop}, 2),
                HasSubstr("--scalars has no part in the diagnosis of a pressure drop"));
    EXPECT_THAT(refused({good, "--pressure-drop", drop, "--pressure-drop", drop}, 2),
                HasSubstr("diagnose takes one pressure drop, 2 are given"));
    EXPECT_THAT(refused({good, "--pressure-drop", drop, "--calibrate"}, 3),
                HasSubstr("at least 3 curves without an effect; 1 given"));
    refused({good, "--pressure-drop", "nowhere.csv"}, 5);
    const std::string few =
        folder
            .write("few.csv", "velocity_m_s,pressure_drop_Pa\n0.1,50\n0.2,100\n0.3,150\n0.4,200\n")
            .string();
    EXPECT_THAT(refused({good, "--pressure-drop", few}, 3),
                HasSubstr("4 points; a diagnosis needs at least 6"));

    const auto refused_bench = [&](const std::string& keys) {
        return refused(
            {folder.write("bad.toml", bench_text(keys)).string(), "--pressure-drop", drop}, 2);
    };
    EXPECT_THAT(refused_bench("gap = \"2 mm\"\n"), HasSubstr("is no narrow gap"));
    EXPECT_THAT(refused_bench("diameter = \"9 mm\"\n"), HasSubstr("bad.toml"));
    EXPECT_THAT(refused_bench("density_increase = -1\n"), HasSubstr("allowed is more than -1"));
    EXPECT_THAT(refused_bench("added_inertia = -2\n"), HasSubstr("quadratic loss negative"));
    EXPECT_THAT(refused_bench("metal_coverage = 0.3\ndiameter = \"4 mm\"\n"),
                HasSubstr("excludes bench.diameter"));
    EXPECT_THAT(refused_bench("gapp = \"1 um\"\n"), HasSubstr("did you mean"));
}

// 1 - (1 - f)^2 = 0.321 of the reference cell, which has a braid ratio of tan 21 degrees.
TEST(PressureFile, TakesTheMetalCoverageForTheBraidRatio)
{
    const test::TemporaryFolder folder;
    const PressureFile file =
        read_pressure_file(folder.write("bench.toml", bench_text("metal_coverage = 0.321\n")));
    EXPECT_NEAR(file.bench.device.braid_ratio, 0.3839, 0.002);
}

TEST(DiagnoseForceCurve, FindsAnOffsetAndWritesAPressFileWithIt)
{
    const test::TemporaryFolder folder;
    const std::string press =
        folder
            .write("press.toml",
                   "[device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n"
                   "forces = \"wire-theory\"\n[press]\nnodes_per_ring = 8\nstroke = \"2 mm\"\n"
                   "step = \"0.2 mm\"\n")
            .string();
    // Its own press test, read by a bench whose zero lies 0.2 mm above the device.
    const fs::path curve = folder.path() / "curve.csv";
    const test::Program pressed({"press", press, "--set", "press.zero_offset=0.2 mm", "--output",
                                 (folder.path() / "states.csv").string()},
                                folder.path());
    ASSERT_EQ(pressed.wait(), 0) << pressed.err();
    std::ifstream states(folder.path() / "states.csv");
    std::ofstream text(curve);
    text << "displacement_mm,force_mN\n";
    std::string line;
    std::getline(states, line);
    while (std::getline(states, line)) {
        const std::size_t second = line.find(',', line.find(',') + 1);
        text << line.substr(0, second) << "\n";
    }
    text.close();

    const fs::path output = folder.path() / "out";
    const Ended ended = diagnosed(
        {press, "--force-curve", curve.string(), "--output", output.string()}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("zero_offset"));
    const auto result = json_in(output / "diagnosis.json");
    EXPECT_EQ(result["answer"]["effects"][0], nlohmann::json({"zero_offset"}));
    EXPECT_NEAR(read_press_file(output / "case_with_zero_offset.toml").options.reading.zero_offset,
                0.2e-3, 0.05e-3);
}

TEST(PressFile, RefusesFactorsAndFrictionOutOfRange)
{
    const test::TemporaryFolder folder;
    const fs::path file =
        folder.write("press.toml",
                     "[device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"");
    EXPECT_THROW(read_press_file(file, {"press.friction=-0.1"}), ConfigError);
    EXPECT_THROW(read_press_file(file, {"press.radial_factor=0"}), ConfigError);
    EXPECT_THROW(read_press_file(file, {"press.zero_offset=0.1"}), ConfigError);
}

}  // namespace braidzone
