// [second_device], the neck and --frames through the program, on the shipped sidewall aneurysm.

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class SecondDeviceRun : public testing::Test {
protected:
    void SetUp() override
    {
        const fs::path shipped = fs::path(BRAIDZONE_SOURCE_DIR) / "cases" / "sidewall_aneurysm";
        for (const char* file : {"vessel.stl", "centerline.vtp", "case.toml"})
            fs::copy_file(shipped / file, folder_.path() / file);
    }

    void add_to_case(const std::string& text)
    {
        std::ofstream(folder_.path() / "case.toml", std::ios::app) << text;
    }

    /// Exit status of a verb on the case.
    int run(const std::string& verb, const Words& more = {})
    {
        Words words = {verb, (folder_.path() / "case.toml").string()};
        words.insert(words.end(), more.begin(), more.end());
        const test::Program program(words, folder_.path());
        const int status = program.wait();
        out_ = program.out();
        err_ = program.err();
        return status;
    }

    nlohmann::json summary() const
    {
        std::ifstream file(folder_.path() / "case.out" / "summary.json");
        return nlohmann::json::parse(file);
    }

    bool is_there(const std::string& file) const
    {
        return fs::exists(folder_.path() / "case.out" / file);
    }

    int count_in_output(const std::string& piece) const
    {
        int count = 0;
        for (std::size_t at = out_.find(piece); at != std::string::npos;
             at = out_.find(piece, at + 1))
            ++count;
        return count;
    }

    test::TemporaryFolder folder_;
    std::string out_, err_;
};

const std::string second_pipeline =
    "\n[second_device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"14 mm\"\n"
    "landing_distal = \"22 mm\"\n";

double value(const nlohmann::json& quantities, const char* name)
{
    return quantities.at(name).at("value").get<double>();
}

// The second device rests on the first one, two wires of 30 um and more inside it: on the landing
// zones its radius is smaller by that. Both resistances act over the neck.
TEST_F(SecondDeviceRun, LiesInsideTheFirstAndAddsItsResistance)
{
    add_to_case(second_pipeline);
    ASSERT_EQ(run("deploy"), 0) << err_;
    EXPECT_TRUE(is_there("second_device.vtp"));
    EXPECT_TRUE(is_there("second_wires.vtp"));
    const auto record = summary();
    const auto first = record["quantities"], second = record["second_device"]["quantities"];
    EXPECT_LT(value(second, "mean_radial_expansion"),
              value(first, "mean_radial_expansion") - 30e-6);
    EXPECT_NEAR(value(second, "resting_length"), 14e-3, 0.1e-3);
    EXPECT_EQ(value(second, "nodes_outside_vessel"), 0.0);
    EXPECT_EQ(value(second, "inverted_rhombi"), 0.0);
    EXPECT_GT(value(second, "resistance_integral_surface"), 0.0);
    EXPECT_GT(value(first, "resistance_integral_surface"),
              1.5 * value(second, "resistance_integral_surface"));
    // The neck of 4.5 mm, 5.3 mm with the fillet of 0.4 mm, lies on the outer wall, 1.9 mm beyond
    // an axis of 20.05 mm radius: 4.1 to 4.8 mm of the centerline about 15 mm.
    for (const auto& quantities : {first, second}) {
        EXPECT_NEAR(0.5 * (value(quantities, "neck_from") + value(quantities, "neck_to")), 15e-3,
                    0.5e-3);
        EXPECT_NEAR(value(quantities, "neck_to") - value(quantities, "neck_from"), 4.45e-3, 0.5e-3);
    }
}

TEST_F(SecondDeviceRun, RefusesALandingThatDoesNotFitAndSaysWhichDevice)
{
    add_to_case(second_pipeline);
    EXPECT_EQ(run("deploy", {"--set", "second_device.landing_distal=5 mm"}), 3);
    EXPECT_NE(err_.find("second_device: "), std::string::npos) << err_;
    EXPECT_FALSE(fs::exists(folder_.path() / "case.out"));
}

TEST_F(SecondDeviceRun, SaysWhatHoldsForBothDevicesOnce)
{
    add_to_case(second_pipeline);
    ASSERT_EQ(run("deploy"), 0) << err_;
    const auto warnings = summary()["warnings"].get<Words>();
    for (const std::string& warning : warnings)
        EXPECT_EQ(std::count(warnings.begin(), warnings.end(), warning), 1) << warning;

    // A note of the second device alone says so.
    ASSERT_EQ(run("deploy", {"--set", "device.force_scale=50"}), 0) << err_;
    EXPECT_NE(out_.find("note: second device pipeline-flex: force_scale"), std::string::npos)
        << out_;
}

TEST_F(SecondDeviceRun, CheckPrintsNeckForcesReleaseAndBothDevices)
{
    add_to_case(second_pipeline +
                "[[second_device.push_pull]]\nfrom = \"12 mm\"\nto = \"18 mm\"\n"
                "spacing = 0.8\n");
    ASSERT_EQ(run("check"), 0) << err_;
    for (const char* piece :
         {"device      pipeline-flex 4 x 20 mm", "second      pipeline-flex 4 x 14 mm",
          "forces from ", "released at nominal spacing",
          "pushed from 12 to 18 mm, to 0.8 of that spacing", "neck        1"}) {
        EXPECT_NE(out_.find(piece), std::string::npos) << piece << " is not in\n" << out_;
    }
    EXPECT_EQ(count_in_output("neck  "), 2) << out_;
}

TEST_F(SecondDeviceRun, FramesAreWrittenAsATimeSeries)
{
    ASSERT_EQ(run("deploy", {"--frames", "3"}), 0) << err_;
    const auto files = summary()["files"].get<Words>();
    for (const char* file : {"frames.pvd", "frames/frame_0000.vtp", "frames/frame_0002.vtp"}) {
        EXPECT_TRUE(is_there(file)) << file;
        EXPECT_NE(std::find(files.begin(), files.end(), file), files.end()) << file;
    }
    EXPECT_FALSE(is_there("frames/frame_0003.vtp"));
}

TEST_F(SecondDeviceRun, WritesTheSameFilesForBothDevices)
{
    add_to_case(second_pipeline);
    ASSERT_EQ(run("deploy", {"--frames", "2"}), 0) << err_;
    for (const char* file : {"device.vtp", "wires.vtp", "unrolled.vtp", "unrolled.png",
                             "residuals.csv", "frames.pvd", "frames/frame_0001.vtp"}) {
        EXPECT_TRUE(is_there(file)) << file;
        EXPECT_TRUE(is_there(std::string("second_") + file)) << file;
    }
    // The collection of the second device names the shapes of the second device.
    std::ostringstream collection;
    collection << std::ifstream(folder_.path() / "case.out" / "second_frames.pvd").rdbuf();
    EXPECT_NE(collection.str().find("file=\"second_frames/frame_0000.vtp\""), std::string::npos)
        << collection.str();
}

TEST_F(SecondDeviceRun, AGivenNeckWithoutAnOpeningIsNoted)
{
    ASSERT_EQ(run("deploy", {"--set", "deployment.neck={from = \"7 mm\", to = \"9 mm\"}"}), 0)
        << err_;
    EXPECT_TRUE(summary()["quantities"]["mean_radial_expansion_neck"].is_null());
    EXPECT_NE(out_.find("deployment.neck = 7 to 9 mm: the vessel does not open there"),
              std::string::npos)
        << out_;
}

}  // namespace
}  // namespace braidzone
