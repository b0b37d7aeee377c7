// No verb replaces one of its inputs, or a folder that holds one, whether `--force` is given or
// not.

#include "support/case_texts.hpp"
#include "support/folder_contents.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class OutputsAndInputs : public testing::Test {
protected:
    void SetUp() override
    {
        const fs::path cases = fs::path(BRAIDZONE_SOURCE_DIR) / "cases";
        for (const char* file : {"vessel.stl", "centerline.vtp", "case.toml", "phantom.toml"})
            copy(cases / "straight_tube" / file, file);
        copy(cases / "hidden_push" / "measured.csv", "measured/points.csv");
        copy(cases / "paper_2020" / "press_4mm.toml", "press/press.toml");
        copy(cases / "paper_2020" / "synthetic_force.csv", "press/force.csv");
        copy(cases / "bench_pressure" / "bench.toml", "bench/bench.toml");
        copy(cases / "bench_pressure" / "measured.csv", "bench/measured.csv");
        // As if an earlier run had written them, so that nothing else keeps them from being lost.
        for (const char* folder : {".", "measured", "press", "bench"})
            inputs_.write(std::string(folder) + "/summary.json", "{\"program\": \"braidzone\"}");
    }

    void copy(const fs::path& from, const std::string& to) const
    {
        fs::create_directories((inputs_.path() / to).parent_path());
        fs::copy_file(from, inputs_.path() / to);
    }

    std::string file(const std::string& name) const { return (inputs_.path() / name).string(); }

    /// With the output at a place that may not be replaced; nothing may change.
    void expect_refused(Words words, const std::string& output) const
    {
        const auto before = test::folder_contents(inputs_.path());
        words.insert(words.end(), {"--output", file(output)});
        for (const bool force : {false, true}) {
            if (force) words.emplace_back("--force");
            const test::Program program(words, streams_.path());
            // 2 for a folder that is or holds an input, 5 for a file where a folder is to be.
            EXPECT_THAT(program.wait(), testing::AnyOf(2, 5))
                << words.front() << " into " << output;
            EXPECT_THAT(program.err(), testing::StartsWith("braidzone: output ")) << words.front();
            EXPECT_EQ(test::folder_contents(inputs_.path()), before) << words.front();
        }
    }

    test::TemporaryFolder inputs_, streams_;
};

TEST_F(OutputsAndInputs, OfTheChainStayApart)
{
    for (const char* verb : {"run", "deploy", "porous", "export"}) {
        for (const char* output : {"case.toml", "vessel.stl", ".", ".."})
            expect_refused({verb, file("case.toml")}, output);
    }
}

TEST_F(OutputsAndInputs, OfDiagnosesStayApart)
{
    const Words surface = {"diagnose", file("case.toml"), "--measured",
                           file("measured/points.csv")};
    for (const char* output : {"measured", "measured/points.csv", ".", "case.toml"})
        expect_refused(surface, output);
    const Words pressure = {"diagnose", file("bench/bench.toml"), "--pressure-drop",
                            file("bench/measured.csv")};
    for (const char* output : {"bench", "bench/measured.csv", "."})
        expect_refused(pressure, output);
}

TEST_F(OutputsAndInputs, OfPressTestsStayApart)
{
    expect_refused({"press", file("press/press.toml")}, "press/press.toml");
    const Words calibrate = {"calibrate", file("press/press.toml"), "--measured",
                             file("press/force.csv")};
    for (const char* output : {"press/press.toml", "press/force.csv"})
        expect_refused(calibrate, output);
}

TEST_F(OutputsAndInputs, OfPhantomsAndCenterlinesStayApart)
{
    expect_refused({"centerline", file("vessel.stl"), "--length-unit", "mm"}, "vessel.stl");
    // The file of the parameters has the name of one that is to be written.
    fs::rename(inputs_.path() / "phantom.toml", inputs_.path() / "measured" / "vessel.stl");
    const auto before = test::folder_contents(inputs_.path());
    for (const Words& more : {Words{}, Words{"--force"}}) {
        Words words = {"phantom", file("measured/vessel.stl"), "--output", file("measured")};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(test::Program(words, streams_.path()).wait(), 2);
        EXPECT_EQ(test::folder_contents(inputs_.path()), before);
    }
}

}  // namespace
}  // namespace braidzone
