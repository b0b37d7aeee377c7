#include "core/error.hpp"
#include "discrepancy/measured_scalars.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

using testing::HasSubstr;

MeasuredScalars read(const std::string& text)
{
    const test::TemporaryFolder folder;
    return read_measured_scalars(TomlTable::read_file(folder.write("m.toml", text)),
                                 test::tube_centerline(2e-3, 30e-3));
}

std::string refusal(const std::string& text)
{
    try {
        read(text);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace

TEST(MeasuredScalars, ReadValuesWithTheirDeviations)
{
    const MeasuredScalars scalars =
        read("implanted_length = \"17.2 mm\"\nimplanted_length_sd = \"300 um\"\n");
    EXPECT_FALSE(scalars.values[0].has_value());
    EXPECT_FALSE(scalars.values[1].has_value());
    EXPECT_DOUBLE_EQ(scalars.values[2]->value, 17.2e-3);
    EXPECT_DOUBLE_EQ(scalars.values[2]->sd, 0.3e-3);
}

TEST(MeasuredScalars, TakeAPointForAnEnd)
{
    const MeasuredScalars scalars =
        read("proximal_end = [\"1 mm\", \"0 mm\", \"7.5 mm\"]\nproximal_end_sd = \"0.2 mm\"\n");
    EXPECT_NEAR(scalars.values[1]->value, 7.5e-3, 1e-6);
}

TEST(MeasuredScalars, RefuseWhatIsIncomplete)
{
    EXPECT_THAT(refusal("distal_end = \"20 mm\"\n"),
                HasSubstr("distal_end stands without distal_end_sd; a measured value needs both"));
    EXPECT_THAT(refusal("distal_end_sd = \"1 mm\"\n"),
                HasSubstr("distal_end_sd stands without distal_end"));
    EXPECT_THAT(refusal("distal_end = \"20 mm\"\ndistal_end_sd = \"0 mm\"\n"),
                HasSubstr("distal_end_sd = 0 mm; a standard deviation must be positive"));
    EXPECT_THAT(refusal("distal_ned = \"20 mm\"\n"), HasSubstr("distal_end"));
}

}  // namespace braidzone
