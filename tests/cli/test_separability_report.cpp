#include "cli/separability_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace braidzone {
namespace {

using testing::HasSubstr;

/// a is seen and can be taken for b, b is seen, c is not, d could not be simulated.
ChannelSeparability four_effects()
{
    const double none = std::numeric_limits<double>::quiet_NaN();
    ChannelSeparability channels;
    channels.channels = "surface";
    channels.separability.names = {"a", "b", "c", "d"};
    channels.separability.detection.resize(4);
    channels.separability.detection << 12.0, 150.0, 1.0, none;
    channels.separability.separation.resize(4, 4);
    channels.separability.separation << 0.0, 2.5, 9.0, none, 8.0, 0.0, 7.0, none, 0.5, 0.5, 0.0,
        none, none, none, none, none;
    return channels;
}

}  // namespace

TEST(SeparabilityText, SaysWhatCannotBeSeenOrToldApart)
{
    const std::string text = separability_text(four_effects());
    EXPECT_THAT(text, HasSubstr("surface: d' of the effect in the row"));
    EXPECT_THAT(text, HasSubstr("cannot be seen: c\n"));
    EXPECT_THAT(text, HasSubstr("could be taken: b for a\n"));
    EXPECT_THAT(text, HasSubstr(" 1 a                           12.0  0.0  2.5  9.0    -\n"));
    EXPECT_THAT(text, HasSubstr(" 2 b                            150"));
}

TEST(SeparabilityJson, HasNullForWhatCouldNotBeSimulated)
{
    const auto json = separability_as_json(four_effects());
    EXPECT_EQ(json["channels"], "surface");
    EXPECT_EQ(json["effects"][3], "d");
    EXPECT_EQ(json["against_none"][1], 150.0);
    EXPECT_TRUE(json["against_none"][3].is_null());
    EXPECT_EQ(json["separation"][0][1], 2.5);
    EXPECT_TRUE(json["separation"][1][3].is_null());
}

}  // namespace braidzone
