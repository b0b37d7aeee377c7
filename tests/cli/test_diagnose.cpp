// The verb diagnose as a user starts it, on the shipped case with a push hidden in its measurement.

#include "cli/case_file.hpp"
#include "cli/effect_case.hpp"
#include "core/error.hpp"
#include "discrepancy/effect.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path hidden_push = fs::path(BRAIDZONE_SOURCE_DIR) / "cases/hidden_push";

struct Ended {
    int status = 0;
    std::string out, err;
};

Ended run(std::vector<std::string> arguments, const fs::path& folder)
{
    arguments.insert(arguments.begin(), "diagnose");
    const test::Program program(arguments, folder);
    const int status = program.wait();
    return {status, program.out(), program.err()};
}

/// Starts a diagnosis and ends it as a power failure would once it keeps a few simulations.
void kill_after_some_simulations(std::vector<std::string> arguments, const fs::path& folder,
                                 const fs::path& kept)
{
    arguments.insert(arguments.begin(), "diagnose");
    const test::Program program(arguments, folder);
    constexpr std::uintmax_t some = 10000;  // bytes, five of them or so
    constexpr auto moment = std::chrono::milliseconds(20);
    for (int i = 0; i < 15000 && !(fs::exists(kept) && fs::file_size(kept) > some); ++i)
        std::this_thread::sleep_for(moment);
    program.send(SIGKILL);
    EXPECT_EQ(program.wait(), 128 + SIGKILL);
}

nlohmann::json json_in(const fs::path& file)
{
    return nlohmann::json::parse(std::ifstream(file));
}

std::string first_lines(const fs::path& file, int count)
{
    std::ifstream text(file);
    std::string lines, line;
    for (int i = 0; i < count && std::getline(text, line); ++i)
        lines += line + "\n";
    return lines;
}

/// A case that differs from the shipped one by what follows it.
fs::path case_with(const test::TemporaryFolder& folder, const std::string& more)
{
    const fs::path vessel = fs::path(BRAIDZONE_SOURCE_DIR) / "cases/sidewall_aneurysm";
    return folder.write("case.toml",
                        "[vessel]\nsurface = \"" + (vessel / "vessel.stl").string() +
                            "\"\nlength_unit = \"mm\"\ncenterline = \"" +
                            (vessel / "centerline.vtp").string() +
                            "\"\n[device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = "
                            "\"20 mm\"\n[deployment]\nlanding_distal = \"25 mm\"\n" +
                            more);
}

}  // namespace

TEST(DiagnoseVerb, NamesTheHiddenPushAndWritesACaseWithIt)
{
    const test::TemporaryFolder folder;
    const fs::path output = folder.path() / "out";
    const std::vector<std::string> arguments = {(hidden_push / "case.toml").string(),
                                                "--measured",
                                                (hidden_push / "measured.csv").string(),
                                                "--scalars",
                                                (hidden_push / "measured.toml").string(),
                                                "--output",
                                                output.string()};
    // Killed after some simulations, it goes on from there.
    kill_after_some_simulations(arguments, folder.path(), folder.path() / ".out.simulations");
    const Ended ended = run(arguments, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("simulations were those of an interrupted run"));
    EXPECT_FALSE(fs::exists(folder.path() / ".out.simulations"));
    EXPECT_THAT(ended.out, HasSubstr("local_push: the operator pushed"));
    const auto result = json_in(output / "diagnosis.json");
    EXPECT_EQ(result["answer"]["finding"], "named");
    EXPECT_EQ(result["answer"]["effects"], nlohmann::json::parse(R"([["local_push"]])"));
    EXPECT_GT(fs::file_size(output / "discrepancy.png"), 1000u);
    EXPECT_GT(result["gaps"]["held_out"]["before"]["rms"]["value"].get<double>(), 0.0);
    EXPECT_GT(result["folds"]["choices"].size(), 20u);
    const std::string page = first_lines(output / "report.html", 100000);
    EXPECT_THAT(
        page, testing::AllOf(HasSubstr("local_push: the operator pushed"),
                             HasSubstr("data:image/png;base64,"), testing::EndsWith("</html>\n")));

    // The new case holds the push that the diagnosis reports.
    const Case fixed = read_case(output / "case_with_local_push.toml");
    ASSERT_EQ(fixed.schedule.windows.size(), 1u);
    for (const auto& effect : result["effects"]) {
        if (effect["effect"] != "local_push") continue;
        const auto& parameters = effect["parameters"]["local_push"];
        EXPECT_NEAR(fixed.schedule.windows[0].spacing,
                    1.0 + parameters["spacing_change"]["value"].get<double>(), 1e-9);
        EXPECT_NEAR(0.5e3 * (fixed.schedule.windows[0].from + fixed.schedule.windows[0].to),
                    parameters["centre"]["value"].get<double>(), 1e-6);
        EXPECT_NEAR(parameters["centre"]["value"].get<double>(), 15.0, 1.0);
    }
    EXPECT_THAT(first_lines(output / "case_with_local_push.toml", 9),
                testing::AllOf(HasSubstr("found by braidzone diagnose"),
                               HasSubstr("deployment.push_pull.0.spacing: absent -> 0.")));
}

// Places on some of the measured points, with a density that says little: what is simulated there
// is reported before and after, as are length and force.
TEST(DiagnoseVerb, TakesADensityMapAndAForce)
{
    const test::TemporaryFolder folder;
    std::ifstream points(hidden_push / "measured.csv");
    std::string map = "x_mm,y_mm,z_mm,pore_density_per_mm2,sd_per_mm2\n", line;
    std::getline(points, line);
    for (int i = 0; std::getline(points, line); ++i)
        map += i % 60 == 0 ? line + ",25,15\n" : "";
    const fs::path density = folder.write("density.csv", map);
    std::ifstream ends(hidden_push / "measured.toml");
    const fs::path scalars = folder.write(
        "measured.toml", std::string(std::istreambuf_iterator<char>(ends), {}) +
                             "contact_force = \"1.1 N\"\ncontact_force_sd = \"0.4 N\"\n");
    const fs::path output = folder.path() / "out";
    const Ended ended = run({(hidden_push / "case.toml").string(), "--measured",
                             (hidden_push / "measured.csv").string(), "--scalars", scalars.string(),
                             "--density-map", density.string(), "--output", output.string()},
                            folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("density increase at the neck [%]"));
    const auto result = json_in(output / "diagnosis.json");
    EXPECT_EQ(result["answer"]["effects"], nlohmann::json::parse(R"([["local_push"]])"));
    std::map<std::string, nlohmann::json> channels;
    for (const auto& channel : result["channels"])
        channels[channel["name"]] = channel;
    const auto& length = channels.at("implanted_length");
    EXPECT_NEAR(length["measured"].get<double>(), 25.52 - 11.32, 1e-9);  // between the ends
    EXPECT_NEAR(length["after"].get<double>(), 14.2, 3.0 * length["sd"].get<double>());
    EXPECT_GT(length["before"].get<double>(), 16.0);
    EXPECT_EQ(channels.at("contact_force")["measured"], 1.1);
    EXPECT_EQ(channels.at("density_map_mean")["measured"], 25.0);
    EXPECT_GT(channels.at("density_map_mean")["after"].get<double>(),
              1.2 * channels.at("density_map_mean")["before"].get<double>());
    EXPECT_GT(channels.at("mean_density_increase_neck")["after"].get<double>(), 60.0);
    EXPECT_GT(result["density_map"]["places"].size(), 20u);
    EXPECT_EQ(result["density_map"]["unit"], "1/mm^2");
    EXPECT_THAT(
        first_lines(output / "report.html", 100000),
        testing::AllOf(HasSubstr("Length, density and force"), HasSubstr("pore density at the ")));
    EXPECT_TRUE(result["inputs"].contains("density_map"));
}

TEST(DiagnoseVerb, RefusesADensityMapThatItCannotUse)
{
    const test::TemporaryFolder folder;
    const std::string measured = (hidden_push / "measured.csv").string();
    const std::string good = (hidden_push / "case.toml").string();
    const std::string header = "x_mm,y_mm,z_mm,metal_coverage,sd\n";
    const auto density = [&](const std::string& lines) {
        return folder.write("density.csv", header + lines).string();
    };
    const auto refused = [&](const std::vector<std::string>& more, int status) {
        std::vector<std::string> arguments = {good};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ended ended = run(arguments, folder.path());
        EXPECT_EQ(ended.status, status) << ended.err;
        return ended.err;
    };
    EXPECT_THAT(refused({"--measured", measured, "--density-map", density("1,2,3,0.3,-0.1\n")}, 3),
                HasSubstr("density.csv:2: sd = -0.1; a standard deviation must be positive"));
    EXPECT_THAT(refused({"--measured", measured, "--density-map", density("900,2,3,0.3,0.1\n")}, 3),
                HasSubstr("density map"));
    EXPECT_THAT(refused({"--calibrate", "--measured", measured, "--density-map",
                         density("1,2,3,0.3,0.1\n")},
                        2),
                HasSubstr("--density-map has no part in --calibrate"));
    EXPECT_THAT(refused({"--separability", "--density-map", density("1,2,3,0.3,0.1\n")}, 2),
                HasSubstr("leave --measured, --scalars and --density-map out"));
}

TEST(DiagnoseVerb, RefusesWhatItCannotUse)
{
    const test::TemporaryFolder folder;
    const std::string measured = (hidden_push / "measured.csv").string();
    const std::string good = (hidden_push / "case.toml").string();
    EXPECT_EQ(run({good}, folder.path()).status, 2);
    EXPECT_EQ(run({good, "--measured", "nowhere.csv"}, folder.path()).status, 5);
    const Ended two = run({good, "--measured", measured, "--measured", measured}, folder.path());
    EXPECT_EQ(two.status, 2);
    EXPECT_THAT(two.err, HasSubstr("takes one measured surface, 2 are given"));
    const Ended calibrate =
        run({good, "--calibrate", "--measured", measured, "--scalars", "m.toml"}, folder.path());
    EXPECT_EQ(calibrate.status, 2);
    EXPECT_THAT(calibrate.err, HasSubstr("--scalars has no part in --calibrate"));

    const Ended axial = run(
        {case_with(folder, "axial = \"free\"\n").string(), "--measured", measured}, folder.path());
    EXPECT_EQ(axial.status, 2);
    EXPECT_THAT(axial.err, HasSubstr("deployment.axial = \"free\" is not covered by diagnose"));
    const Ended second =
        run({case_with(folder,
                       "[second_device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = "
                       "\"10 mm\"\nlanding_distal = \"20 mm\"\n")
                 .string(),
             "--measured", measured},
            folder.path());
    EXPECT_EQ(second.status, 2);
    EXPECT_THAT(second.err, HasSubstr("second_device is not covered by diagnose"));
}

TEST(DiagnoseVerb, KeepsAFolderThatItDidNotWrite)
{
    const test::TemporaryFolder folder;
    folder.write("mine/notes.txt", "keep");
    const Ended ended = run(
        {(hidden_push / "case.toml").string(), "--measured",
         (hidden_push / "measured.csv").string(), "--output", (folder.path() / "mine").string()},
        folder.path());
    EXPECT_EQ(ended.status, 5);
    EXPECT_THAT(ended.err, HasSubstr("it holds no diagnosis.json of a run"));
    EXPECT_TRUE(fs::exists(folder.path() / "mine/notes.txt"));
}

TEST(DiagnoseVerb, LearnsANoiseFloor)
{
    const test::TemporaryFolder folder;
    const std::string measured = (hidden_push / "measured.csv").string();
    const fs::path output = folder.path() / "noise.json";
    const Ended ended =
        run({(hidden_push / "case.toml").string(), "--calibrate", "--measured", measured,
             "--measured", measured, "--measured", measured, "--output", output.string()},
            folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(json_in(output)["source"], "learned from 3 measurements without an effect");
}

TEST(CaseFile, ReadsTheImagingAndTheWallOffset)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(
        case_with(folder,
                  "[measurement]\nvoxel_size = \"0.2 mm\"\nblur = \"0.4 mm\"\nthreshold = 0.4\n"
                  "blooming = \"0.1 mm\"\nshift = [\"1 mm\", \"0 mm\", \"-2 mm\"]\n"
                  "pivot = [\"5 mm\", \"0 mm\", \"0 mm\"]\n"
                  "rotation = [\"0 deg\", \"180 deg\", \"0 deg\"]\n"),
        {"vessel.wall_offset=-0.05 mm"});
    EXPECT_DOUBLE_EQ(job.measurement.chain.voxel_size, 0.2e-3);
    EXPECT_DOUBLE_EQ(job.measurement.chain.blur, 0.4e-3);
    EXPECT_DOUBLE_EQ(job.measurement.chain.threshold, 0.4);
    EXPECT_DOUBLE_EQ(job.measurement.blooming, 0.1e-3);
    EXPECT_LT((job.measurement.shift - Vec3(1e-3, 0.0, -2e-3)).norm(), 1e-15);
    EXPECT_LT((job.measurement.pivot - Vec3(5e-3, 0.0, 0.0)).norm(), 1e-15);
    EXPECT_LT((job.measurement.rotation - Vec3(0.0, 3.14159265358979, 0.0)).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(job.vessel.wall_offset, -0.05e-3);
    try {
        read_case(case_with(folder, "[measurement]\nrotation = [\"1 deg\"]\n"));
        FAIL();
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("measurement.rotation has 1 angles; three are needed"));
    }
}

TEST(CaseFile, ReadsTheStraighteningOfTheVessel)
{
    const test::TemporaryFolder folder;
    const auto read = [&](const std::string& keys) {
        return read_case(case_with(folder, "[vessel.straightening]\n" + keys)).vessel.straightening;
    };
    const std::string window = "share = 0.3\ncentre = \"15 mm\"\nhalf_width = \"8 mm\"\n";
    const VesselStraightening found = read(window + "kept_from = \"5 mm\"\nkept_to = \"25 mm\"\n");
    EXPECT_EQ(found.share, 0.3);
    EXPECT_DOUBLE_EQ(found.centre, 15e-3);
    EXPECT_DOUBLE_EQ(found.half_width, 8e-3);
    EXPECT_DOUBLE_EQ(found.kept_from, 5e-3);
    EXPECT_DOUBLE_EQ(found.kept_to, 25e-3);
    EXPECT_EQ(read(window).kept_to, 0.0);
    const auto refusal = [&](const std::string& keys) -> std::string {
        try {
            read(keys);
        } catch (const ConfigError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(refusal(window + "kept_from = \"5 mm\"\n"),
                HasSubstr("straightening.kept_from is given without its counterpart"));
    EXPECT_THAT(refusal("share = 1.3\ncentre = \"15 mm\"\nhalf_width = \"8 mm\"\n"),
                HasSubstr("vessel.straightening: straightening: share = 1.3; allowed are 0"));
}

// Each effect of the catalogue reaches the case file: the case with it differs in the effect's own
// keys, and reads back to the same model.
TEST(EffectCase, HoldsEveryEffectInItsOwnKeys)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(case_with(folder, ""));
    EffectSetting setting;
    setting.base = {.device = job.device,
                    .landing_distal = 25e-3,
                    .schedule = job.schedule,
                    .options = job.deployment,
                    .straightening = {},
                    .imaging = {}};
    setting.from = 5e-3;
    setting.to = 25e-3;
    const std::map<std::string, std::string> key = {
        {"registration", "measurement."},
        {"blooming", "measurement.blooming: "},
        {"vessel_offset", "vessel.wall_offset: "},
        {"wall_compliance", "deployment.wall_stiffness: "},
        {"landing_offset", "deployment.landing_distal: "},
        {"nominal_diameter", "device.diameter: "},
        {"braid_ratio", "device.braid_ratio: "},
        {"local_push", "deployment.push_pull.0."},
        {"local_pull", "deployment.push_pull.0."},
        {"vessel_straightening", "vessel.straightening."},
        {"sliding", "deployment.sliding: "},
        {"axial_twist", "deployment.twist.0."},
        {"incomplete_opening_proximal", "deployment.incomplete_opening.0."},
        {"incomplete_opening_distal", "deployment.incomplete_opening.0."},
        {"free_hub", "deployment.hub_shift: "}};
    for (const Effect& effect : effect_catalogue()) {
        FittedEffect fitted;
        fitted.name = effect.name;
        fitted.parameters = effect.parameters(setting);
        for (const EffectParameter& parameter : fitted.parameters) {
            // off the prior's mean, to the side that the bounds allow
            const double step = 0.5 * parameter.prior_sd;
            fitted.values.push_back(parameter.prior_mean + step <= parameter.upper
                                        ? parameter.prior_mean + step
                                        : parameter.prior_mean - step);
            fitted.sd.push_back(step);
        }
        EffectFit fit;
        fit.effects = {fitted};
        const Model model = effect.apply(setting, fitted.values);
        const auto changes = changed_keys(job, case_of(job, model));
        ASSERT_FALSE(changes.empty()) << effect.name;
        for (const std::string& change : changes) {
            // A braid that slides may end elsewhere, too.
            const bool is_landing =
                effect.name == "sliding" && change.starts_with("deployment.landing_distal: ");
            EXPECT_TRUE(is_landing || change.starts_with(key.at(effect.name)))
                << effect.name << ": " << change;
        }
        const Case back = read_case(
            folder.write(effect.name + ".toml", effect_case_text(job, model, fit, "measured.csv")));
        EXPECT_THAT(changed_keys(case_of(job, model), back), testing::IsEmpty()) << effect.name;
    }
}

}  // namespace braidzone
