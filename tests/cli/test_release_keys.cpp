// [deployment] release and spacing_table, and what the resolved case keeps of them and of [device].

#include "cli/case_file.hpp"
#include "cli/resolved_case.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

std::string case_text(const std::string& device_keys, const std::string& deployment_keys)
{
    return "[vessel]\nsurface = \"vessel.stl\"\nlength_unit = \"mm\"\n"
           "[device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n" +
           device_keys + "[deployment]\nlanding_distal = \"18 mm\"\n" + deployment_keys;
}

class ReleaseKeys : public testing::Test {
protected:
    Case read(const std::string& device_keys, const std::string& deployment_keys)
    {
        folder_.write("spacing.csv", "s_mm,lambda\n0,1\n10,0.5\n");
        return read_case(folder_.write("case.toml", case_text(device_keys, deployment_keys)));
    }

    std::string message(const std::string& keys)
    {
        try {
            read("", keys);
        } catch (const ConfigError& error) {
            const std::string what = error.what();
            return what.substr(what.find("case.toml"));
        }
        return "accepted";
    }

    /// The case as its own resolved text gives it.
    Case again(const Case& job)
    {
        return read_case(folder_.write("again.toml", resolved_case_text(job)));
    }

    test::TemporaryFolder folder_;
};

TEST_F(ReleaseKeys, AreNominalByDefault)
{
    const Case job = read("", "");
    EXPECT_EQ(job.schedule.sliding, 0.0);
    EXPECT_TRUE(job.schedule.table.empty());
}

TEST_F(ReleaseKeys, ReadTheModeAndKeepIt)
{
    const Case job = read("", "release = \"force_free\"\n");
    EXPECT_EQ(job.schedule.sliding, 1.0);
    EXPECT_EQ(again(job).schedule.sliding, 1.0);
    EXPECT_EQ(message("release = \"forcefree\"\n"),
              "case.toml:10: deployment.release = \"forcefree\" is not known; did you mean "
              "\"force_free\"?");
}

TEST_F(ReleaseKeys, ReadTheTableBesideTheCaseAndKeepIt)
{
    const Case job = read("", "spacing_table = \"spacing.csv\"\n");
    ASSERT_EQ(job.schedule.table.size(), 2u);
    EXPECT_DOUBLE_EQ(job.schedule.table[1].arc_length, 10e-3);
    EXPECT_EQ(job.schedule.table[1].spacing, 0.5);
    EXPECT_EQ(job.schedule.table_file, folder_.path() / "spacing.csv");
    EXPECT_EQ(again(job).schedule.table.size(), 2u);
}

TEST_F(ReleaseKeys, RefuseATableBesideAnotherSchedule)
{
    EXPECT_EQ(
        message("spacing_table = \"spacing.csv\"\nrelease = \"force_free\"\n"),
        "case.toml:10: deployment.spacing_table: spacing_table is the whole schedule; sliding, "
        "which release = \"force_free\" is in full, cannot stand beside it: keep one of them");
    EXPECT_EQ(message("spacing_table = \"spacing.csv\"\n[[deployment.push_pull]]\n"
                      "from = \"1 mm\"\nto = \"2 mm\"\nspacing = 0.5\n"),
              "case.toml:10: deployment.spacing_table: spacing_table is the whole schedule; "
              "push_pull cannot stand beside it: keep one of them");
    EXPECT_THROW(read("", "spacing_table = \"absent.csv\"\n"), IoError);
}

TEST_F(ReleaseKeys, ComeWithTheSourceOfForcesInTheResolvedCase)
{
    const Case job = read(
        "forces = \"wire-theory\"\npoisson_ratio = 0.33\ndistal_flare = \"0.1 mm\"\n"
        "proximal_flare = \"-0.2 mm\"\nflare_length = \"2 mm\"\n",
        "");
    const FlowDiverter device = again(job).device;
    EXPECT_EQ(device.forces, ForceSource::wire_theory);
    EXPECT_EQ(device.youngs_modulus, 200e9);
    EXPECT_EQ(device.poisson_ratio, 0.33);
    EXPECT_EQ(device.distal_flare, job.device.distal_flare);
    EXPECT_EQ(device.proximal_flare, job.device.proximal_flare);
    EXPECT_EQ(device.flare_length, job.device.flare_length);
    EXPECT_EQ(device.surface_coefficient, 0.6);
}

// A device of wires only has no springs to write down.
TEST_F(ReleaseKeys, LeaveUnknownSpringsOutOfTheResolvedCase)
{
    std::string text = case_text("any_size = true\n", "");
    text.replace(text.find("pipeline-flex"), 13, "surpass-streamline");
    const Case job = read_case(folder_.write("surpass.toml", text));
    EXPECT_EQ(job.device.forces, ForceSource::wire_theory);
    EXPECT_EQ(resolved_case_text(job).find("surface_coefficient"), std::string::npos);
    const FlowDiverter device = again(job).device;
    EXPECT_EQ(device.forces, ForceSource::wire_theory);
    EXPECT_EQ(device.braid_ratio, job.device.braid_ratio);
}

}  // namespace
}  // namespace braidzone
