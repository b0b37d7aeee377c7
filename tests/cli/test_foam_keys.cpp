// The flow that an exported OpenFOAM case solves: keys of [[export]] and of [fluid].

#include "cli/case_file.hpp"
#include "cli/resolved_case.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

class FoamKeys : public testing::Test {
protected:
    Case read(const std::string& export_keys, const std::string& fluid_keys = "")
    {
        folder_.write("flow.csv", "time_s,flow_rate_mL_s\n0,3\n0.3,6\n0.8,3\n");
        return read_case(folder_.write(
            "case.toml",
            "[vessel]\nsurface = \"vessel.stl\"\nlength_unit = \"mm\"\n"
            "[device]\nname = \"pipeline-flex\"\ndiameter = \"4 mm\"\nlength = \"20 mm\"\n"
            "[deployment]\nlanding_distal = \"18 mm\"\n"
            "[fluid]\n" +
                fluid_keys + "[[export]]\nformat = \"openfoam\"\n" + export_keys));
    }

    FoamFlow flow(const std::string& keys) { return read(keys).exports.openfoam->flow; }

    std::string message(const std::string& export_keys, const std::string& fluid_keys = "")
    {
        try {
            read(export_keys, fluid_keys);
        } catch (const ConfigError& error) {
            const std::string what = error.what();
            return what.substr(what.find("case.toml"));
        }
        return "accepted";
    }

    /// The case as its own resolved text gives it.
    Case again(const Case& job)
    {
        const Case copy = read_case(folder_.write("again.toml", resolved_case_text(job)));
        EXPECT_EQ(resolved_case(copy).dump(), resolved_case(job).dump());
        return copy;
    }

    test::TemporaryFolder folder_;
};

TEST_F(FoamKeys, AreSteadyNewtonianAndZeroPressureByDefault)
{
    const Case job = again(read(""));
    const FoamFlow& steady = job.exports.openfoam->flow;
    EXPECT_FALSE(steady.waveform.has_value());
    EXPECT_EQ(steady.inlet_velocity, 0.25);
    EXPECT_TRUE(std::get<OutletPressures>(steady.outlets).pressures.empty());
    EXPECT_FALSE(job.rheology.has_value());
}

TEST_F(FoamKeys, ReadAWaveformBesideTheCase)
{
    const Case job = again(read("waveform = \"flow.csv\"\ncycles = 5\nmax_courant = 0.8\n"));
    const FoamFlow& pulsatile = job.exports.openfoam->flow;
    ASSERT_TRUE(pulsatile.waveform.has_value());
    EXPECT_EQ(pulsatile.waveform->file, folder_.path() / "flow.csv");
    EXPECT_DOUBLE_EQ(pulsatile.waveform->flow_rates[1], 6e-6);
    EXPECT_EQ(pulsatile.cycles, 5);
    EXPECT_EQ(pulsatile.max_courant, 0.8);
    EXPECT_EQ(flow("waveform = \"flow.csv\"\n").cycles, 3);
}

// The mean of the file is 4.5 mL/s; its peak is a third above that.
TEST_F(FoamKeys, ScaleAWaveformToAMean)
{
    const Case job = again(read("waveform = \"flow.csv\"\nmean_flow_rate = \"180 ml/min\"\n"));
    const FlowWaveform& wave = *job.exports.openfoam->flow.waveform;
    EXPECT_NEAR(mean_flow_rate(wave), 3e-6, 1e-20);
    EXPECT_NEAR(wave.flow_rates[1], 4e-6, 1e-20);
    EXPECT_EQ(message("waveform = \"flow.csv\"\nmean_flow_rate = \"0 ml/s\"\n"),
              "case.toml:14: export.mean_flow_rate = 0 is out of range; it must be positive");
    EXPECT_EQ(message("mean_flow_rate = \"3 ml/s\"\n"),
              "case.toml:13: export.mean_flow_rate is for pulsatile flow; it needs a waveform");
}

TEST_F(FoamKeys, RefuseContradictionsAboutTheInflow)
{
    EXPECT_EQ(message("waveform = \"flow.csv\"\ninlet_velocity = \"0.2 m/s\"\n"),
              "case.toml:14: export.inlet_velocity is for steady flow, but a waveform is given; "
              "keep one of them");
    EXPECT_EQ(message("cycles = 3\n"),
              "case.toml:13: export.cycles is for pulsatile flow; it needs a waveform");
    EXPECT_EQ(message("max_courant = 3\n"),
              "case.toml:13: export.max_courant is for pulsatile flow; it needs a waveform");
    EXPECT_EQ(message("waveform = \"flow.csv\"\ncycles = 0\n"),
              "case.toml:14: export.cycles = 0 is out of range; allowed are 1 to 100");
    EXPECT_EQ(message("waveform = \"flow.csv\"\nmax_courant = -1\n"),
              "case.toml:14: export.max_courant = -1 is out of range; it must be positive");
    EXPECT_EQ(message("waveform = \"\"\n"),
              "case.toml:13: export.waveform is empty; expected is a file");
    EXPECT_EQ(
        message("inlet_velocity = \"-0.2 m/s\"\n"),
        "case.toml:13: export.inlet_velocity = -0.2 m/s is out of range; it must be positive");
    EXPECT_THROW(read("waveform = \"absent.csv\"\n"), IoError);
}

TEST_F(FoamKeys, ReadWhatHoldsAtTheOutlets)
{
    EXPECT_TRUE(std::holds_alternative<MurraySplit>(
        again(read("outlets = \"murray\"\n")).exports.openfoam->flow.outlets));
    const auto pressures =
        again(read("outlet_pressures = [\"1 kPa\", \"0 Pa\"]\n")).exports.openfoam->flow.outlets;
    EXPECT_EQ(std::get<OutletPressures>(pressures).pressures, (std::vector<double>{1000.0, 0.0}));
    const auto shares = again(read("outlet_shares = [0.7, 0.3]\n")).exports.openfoam->flow.outlets;
    EXPECT_EQ(std::get<OutletShares>(shares).shares, (std::vector<double>{0.7, 0.3}));
}

TEST_F(FoamKeys, RefuseOutletsThatCannotBe)
{
    EXPECT_EQ(message("outlets = \"muray\"\n"),
              "case.toml:13: export.outlets = \"muray\" is not known; did you mean \"murray\"?");
    EXPECT_EQ(message("outlets = \"murray\"\noutlet_shares = [0.5, 0.5]\n"),
              "case.toml:14: export.outlet_shares is given beside outlets; keep one of them");
    EXPECT_EQ(message("outlet_shares = [1.5, -0.5]\n"),
              "case.toml:13: export.outlet_shares = 1.5 is out of range; it must be positive, 1 at "
              "most");
    EXPECT_EQ(message("outlet_shares = [0.5, 0.4]\n"),
              "case.toml:13: export.outlet_shares sum to 0.9; they must sum to 1");
    EXPECT_EQ(message("outlet_pressures = [0]\n").substr(0, 38),
              "case.toml:13: export.outlet_pressures ");
    EXPECT_EQ(
        message("outlet_pressure = [\"0 Pa\"]\n"),
        "case.toml:13: export.outlet_pressure: unknown key; did you mean \"outlet_pressures\"?");
}

TEST_F(FoamKeys, ReadShearThinningBlood)
{
    const Case job =
        again(read("",
                   "rheology = \"carreau-yasuda\"\nzero_shear_viscosity = \"60 mPa s\"\n"
                   "relaxation_time = \"2 s\"\n"));
    ASSERT_TRUE(job.rheology.has_value());
    EXPECT_EQ(job.rheology->zero_shear_viscosity, 0.06);
    EXPECT_EQ(job.rheology->infinite_shear_viscosity, CarreauYasuda{}.infinite_shear_viscosity);
    EXPECT_EQ(job.rheology->relaxation_time, 2.0);
    EXPECT_EQ(job.fluid.viscosity, 3.5e-3);
}

TEST_F(FoamKeys, RefuseBloodThatCannotBe)
{
    const std::string carreau = "rheology = \"carreau-yasuda\"\n";
    EXPECT_EQ(message("", "rheology = \"carreau\"\n"),
              "case.toml:11: fluid.rheology = \"carreau\" is not known; known are newtonian, "
              "carreau-yasuda");
    EXPECT_EQ(message("", carreau + "power_index = 1.2\n"),
              "case.toml:11: fluid.rheology = \"carreau-yasuda\": power index 1.2 is out of range; "
              "allowed: between 0 and 1");
    EXPECT_EQ(message("", carreau + "relaxation_time = \"-1 s\"\n"),
              "case.toml:12: fluid.relaxation_time = -1 s is out of range; it must be positive");
    // A constant of a model that is not chosen.
    EXPECT_EQ(message("", "power_index = 0.3\n").substr(0, 44),
              "case.toml:11: fluid.power_index: unknown key");
}

}  // namespace
}  // namespace braidzone
