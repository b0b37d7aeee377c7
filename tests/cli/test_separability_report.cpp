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

// c is seen by the ends, as is a; that a can be taken for b is cured by the force alone, and c is
// told from the others once it is seen. Nothing shows d.
TEST(SeparabilityGains, NameTheCheapestMeasurement)
{
    ChannelSeparability ends = four_effects(), force = ends;
    ends.channels = "surface and end markers";
    ends.added = "both ends to 0.3 mm";
    ends.separability.detection[2] = 5.0;
    ends.separability.separation.row(2).head(2).setConstant(4.5);
    force.channels = "surface, end markers and contact force";
    force.added = "the force on the wall to 15 %";
    force.separability = ends.separability;
    force.separability.separation(0, 1) = 3.25;
    const std::vector<ChannelSeparability> all = {four_effects(), ends, force};
    const std::string text = gains_text(all);
    EXPECT_THAT(text, HasSubstr("both ends to 0.3 mm: c / none (1.0 -> 5.0)\n"));
    EXPECT_THAT(text, HasSubstr("the force on the wall to 15 %: a / b (2.5 -> 3.2)\n"));
    const auto json = gains_as_json(all);
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[1]["channels"], "surface, end markers and contact force");
    EXPECT_EQ(json[1]["is_separated"], true);
}

}  // namespace braidzone
