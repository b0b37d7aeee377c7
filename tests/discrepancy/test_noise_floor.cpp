#include "core/error.hpp"
#include "discrepancy/noise_floor.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace braidzone {
namespace {

using testing::HasSubstr;

std::string refusal(std::string text, const std::string& part, const std::string& replacement)
{
    const test::TemporaryFolder folder;
    if (!part.empty()) text.replace(text.find(part), part.size(), replacement);
    try {
        read_noise_floor(folder.write("noise.json", text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace

TEST(NoiseFloor, IsReadBackAsItWasWritten)
{
    const test::TemporaryFolder folder;
    NoiseFloor floor;
    floor.background_sd = 0.047e-3;
    floor.angle_sd = 1.5 * std::numbers::pi / 180.0;
    floor.source = "12 sets";
    const NoiseFloor read = read_noise_floor(folder.write("noise.json", noise_floor_text(floor)));
    EXPECT_NEAR(read.background_sd, 0.047e-3, 1e-18);
    EXPECT_NEAR(read.angle_sd, floor.angle_sd, 1e-15);
    EXPECT_NEAR(read.length_sd, floor.length_sd, 1e-18);
    EXPECT_EQ(read.source, "12 sets");
    EXPECT_THAT(noise_floor_text(floor), HasSubstr("\"registration_angle_sd_deg\": 1.5"));
}

// A noise file of a time when there were none of them.
TEST(NoiseFloor, StandsAtItsDefaultsForHubsDensityAndForce)
{
    const test::TemporaryFolder folder;
    const NoiseFloor read = read_noise_floor(
        folder.write("noise.json",
                     R"({"background_sd_mm": 0.03, "background_length_mm": 3, "offset_sd_mm": 0.01,
            "registration_shift_sd_mm": 0.07, "registration_angle_sd_deg": 0.7, "white_scale": 1,
            "landing_sd_mm": 0.1, "length_sd_mm": 0.1, "contact_force_relative_sd": 0.3})"));
    EXPECT_EQ(read.hub_sd, NoiseFloor{}.hub_sd);
    EXPECT_EQ(read.density_sd, NoiseFloor{}.density_sd);
    EXPECT_EQ(read.density_scale_sd, NoiseFloor{}.density_scale_sd);
    EXPECT_EQ(read.force_sd, 0.3);
}

TEST(NoiseFloor, RefusesWhatIsNone)
{
    const std::string text = noise_floor_text({});
    EXPECT_THAT(refusal(text, "background_sd_mm", "background_mm"),
                HasSubstr("\"background_mm\" is not known; did you mean \"background_sd_mm\"?"));
    EXPECT_THAT(refusal(text, "\"white_scale\": 1.0", "\"white_scale\": 0"),
                HasSubstr("white_scale = 0 must be positive"));
    EXPECT_THAT(refusal(text, "\"white_scale\": 1.0", "\"white_scale\": \"1\""),
                HasSubstr("white_scale is missing or not a number"));
    EXPECT_THAT(refusal("[1]", "", ""), HasSubstr("is not a JSON object"));
    EXPECT_THROW(read_noise_floor("/nowhere/noise.json"), IoError);
}

}  // namespace braidzone
