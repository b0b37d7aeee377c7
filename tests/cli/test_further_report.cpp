#include "cli/further_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

using testing::HasSubstr;

/// Three answers; the ends tell a from the others by 4, b from c by `b_from_c`.
FurtherMeasurement three_answers(double a_from_others, double b_from_c)
{
    FurtherMeasurement further;
    further.answers = {"a", "b", "c"};
    further.channels = {{"end_markers", "both ends to 0.3 mm", {7, 8}}};
    further.pairs = {
        {0, 1, 0.0, {a_from_others}}, {0, 2, 3.0, {a_from_others}}, {1, 2, 1.2, {b_from_c}}};
    further.best = 0;
    return further;
}

}  // namespace

// sqrt(3^2 + 4^2) = 5
TEST(FurtherText, SaysWhichMeasurementWouldSeparateWhat)
{
    EXPECT_EQ(further_text(three_answers(4.0, 3.5)),
              "A measurement of both ends to 0.3 mm would separate them (d' 1.2 -> 3.7).");
    EXPECT_EQ(further_text(three_answers(4.0, 0.5)),
              "A measurement of both ends to 0.3 mm would separate a from b (d' 0.0 -> 4.0), a "
              "from c (d' 3.0 -> 5.0).");
    EXPECT_EQ(further_text(three_answers(1.0, 0.5)),
              "None of the measurements that could be added would separate them; the best, of both "
              "ends to 0.3 mm, would bring d' 1.2 -> 1.3.");
    EXPECT_EQ(further_text({}), "");
}

TEST(FurtherJson, HasEachPairWithEachChannel)
{
    const auto json = further_as_json(three_answers(4.0, 0.5));
    EXPECT_EQ(json["best"], "end_markers");
    const auto& pairs = json["channels"][0]["pairs"];
    ASSERT_EQ(pairs.size(), 3u);
    EXPECT_EQ(pairs[1]["second"], "c");
    EXPECT_DOUBLE_EQ(pairs[1]["with"].get<double>(), 5.0);
    EXPECT_EQ(pairs[1]["is_separated"], true);
    EXPECT_EQ(pairs[2]["is_separated"], false);
    EXPECT_TRUE(further_as_json(three_answers(1.0, 0.5))["best"].is_null());
}

TEST(FurtherTable, HasALineForEachChannel)
{
    EXPECT_THAT(further_table(three_answers(4.0, 3.5)),
                HasSubstr("    both ends to 0.3 mm                                         d' 1.2 "
                          "-> 3.7\n"));
    EXPECT_EQ(further_table({}), "");
}

}  // namespace braidzone
