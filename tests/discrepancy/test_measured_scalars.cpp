#include "core/error.hpp"
#include "discrepancy/measured_scalars.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

TEST(MeasuredScalars, TakeAForceOfAllOrOfAStretch)
{
    const std::string force = "contact_force = \"120 mN\"\ncontact_force_sd = \"0.02 N\"\n";
    const auto whole = read(force).contact_force;
    ASSERT_TRUE(whole.has_value());
    EXPECT_DOUBLE_EQ(whole->force.value, 0.12);
    EXPECT_DOUBLE_EQ(whole->force.sd, 0.02);
    EXPECT_TRUE(std::isinf(whole->from) && std::isinf(whole->to));
    const auto stretch =
        read(force + "contact_force_from = \"18 mm\"\ncontact_force_to = \"24 mm\"\n")
            .contact_force;
    EXPECT_DOUBLE_EQ(stretch->from, 18e-3);
    EXPECT_DOUBLE_EQ(stretch->to, 24e-3);
    EXPECT_THAT(refusal("contact_force = \"1 N\"\n"),
                HasSubstr("contact_force stands without contact_force_sd"));
    EXPECT_THAT(refusal("contact_force = \"0 N\"\ncontact_force_sd = \"1 N\"\n"),
                HasSubstr("contact_force = 0 N; a force on the wall must be positive"));
    EXPECT_THAT(refusal("contact_force = \"1 N\"\ncontact_force_sd = \"-1 N\"\n"),
                HasSubstr("contact_force_sd = -1 N; a standard deviation must be positive"));
    EXPECT_THAT(refusal(force + "contact_force_from = \"1 mm\"\n"),
                HasSubstr("contact_force_from stands without contact_force_to"));
    const std::string backwards = "contact_force_from = \"9 mm\"\ncontact_force_to = \"2 mm\"\n";
    EXPECT_THAT(refusal(backwards), HasSubstr("contact_force_from stands without contact_force"));
    EXPECT_THAT(refusal(force + backwards),
                HasSubstr("contact_force_from = 9 mm; it must be less than contact_force_to = 2"));
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
