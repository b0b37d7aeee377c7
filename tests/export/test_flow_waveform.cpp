#include "core/error.hpp"
#include "export/flow_waveform.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

class Waveform : public testing::Test {
protected:
    FlowWaveform read(const std::string& text)
    {
        return read_flow_waveform(folder_.write("flow.csv", text));
    }

    std::string message(const std::string& text)
    {
        try {
            read(text);
        } catch (const InputError& error) {
            const std::string what = error.what();
            return what.substr(what.find("flow.csv"));
        }
        return "accepted";
    }

    test::TemporaryFolder folder_;
};

TEST_F(Waveform, ReadsTheUnitsOfItsHeader)
{
    const FlowWaveform waveform = read("time_s,flow_rate_mL_s\r\n0,3\r\n 0.25 , 7.5\r\n\n0.8,3\n");
    EXPECT_EQ(waveform.times, (std::vector<double>{0.0, 0.25, 0.8}));
    EXPECT_DOUBLE_EQ(waveform.flow_rates[1], 7.5e-6);
    EXPECT_EQ(period(waveform), 0.8);
    const FlowWaveform slow = read("time_ms,flow_rate_mL_min\n0,60\n250,120\n800,60\n");
    EXPECT_DOUBLE_EQ(slow.times[1], 0.25);
    EXPECT_DOUBLE_EQ(slow.flow_rates[1], 2e-6);
    EXPECT_DOUBLE_EQ(read("time_s,flow_rate_m3_s\n0,0\n1,2e-6\n3,0\n").flow_rates[1], 2e-6);
}

// Triangles of height 2e-6 over a base of 4: mean 1e-6. Steps need not be equal.
TEST_F(Waveform, MeanIsThatOfTheLines)
{
    EXPECT_DOUBLE_EQ(mean_flow_rate(read("time_s,flow_rate_m3_s\n0,0\n1,2e-6\n4,0\n")), 1e-6);
}

TEST_F(Waveform, RefusesWhatIsNoWaveformAndNamesTheLine)
{
    EXPECT_EQ(message("t,q\n0,1\n"),
              "flow.csv:1: \"t,q\" is not the header of a flow waveform; expected is "
              "time_s,flow_rate_mL_s (or time_ms; flow_rate_mL_min, flow_rate_m3_s)");
    EXPECT_EQ(message("").substr(0, 13), "flow.csv:1: \"");
    EXPECT_EQ(message("time_s,flow_rate_L_s\n0,1\n").substr(0, 11), "flow.csv:1:");
    const std::string header = "time_s,flow_rate_mL_s\n";
    EXPECT_EQ(message(header + "0,1\n0.5;2\n1,1\n"),
              "flow.csv:3: \"0.5;2\" is not a point of the waveform; expected are two numbers with "
              "a comma between");
    EXPECT_EQ(message(header + "0,nan\n").substr(0, 11), "flow.csv:2:");
    EXPECT_EQ(message(header + "0,1,1\n").substr(0, 11), "flow.csv:2:");
    EXPECT_EQ(message(header + "0.1,1\n0.5,2\n1,1\n"),
              "flow.csv:2: the first time is 0.1; it must be 0");
    EXPECT_EQ(message(header + "0,1\n0.5,2\n0.5,1\n1,1\n"),
              "flow.csv:4: time 0.5 follows 0.5; times must increase");
    EXPECT_EQ(message(header + "0,1\n0.5,1\n"),
              "flow.csv:3: the waveform has 2 points; at least 3 are expected");
    EXPECT_EQ(message(header + "0,1\n0.5,2\n1,1.1\n"),
              "flow.csv:4: the last flow rate is 1.1 and the first 1; the flow repeats, and the "
              "last point must close the period");
    EXPECT_EQ(message(header + "0,-1\n0.5,0.5\n1,-1\n"),
              "flow.csv: the mean flow rate is -2.5e-07 m^3/s; it must be positive: flow enters at "
              "the inlet");
}

TEST_F(Waveform, RefusesAFileThatIsNotThere)
{
    EXPECT_THROW(read_flow_waveform(folder_.path() / "absent.csv"), IoError);
}

}  // namespace
}  // namespace braidzone
