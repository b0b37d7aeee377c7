#include "discrepancy/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Decide, FindsNothingMissingBelowTheBars)
{
    const Verdict verdict =
        decide({{"local_push", 3.9, 0.0, 0.0}, {"blooming", 1.0, 0.0, 0.0}}, 3.3);
    EXPECT_EQ(verdict.finding, Finding::nothing_missing);
    EXPECT_THAT(verdict.effects, IsEmpty());
    EXPECT_EQ(decide({}, 0.0).finding, Finding::nothing_missing);
}

TEST(Decide, NamesTheOneThatStandsOut)
{
    const Verdict verdict =
        decide({{"blooming", 5.0, 0.0, 0.0}, {"local_push", 40.0, 1.0, 0.0}}, 20.0);
    EXPECT_EQ(verdict.finding, Finding::named);
    EXPECT_THAT(verdict.effects, ElementsAre("local_push"));
    EXPECT_FALSE(verdict.has_unexplained_rest);
}

TEST(Decide, GivesASetWithinABayesFactorOfTwenty)
{
    const Verdict verdict = decide({{"vessel_offset", 30.0, 0.0, 0.0},
                                    {"wall_compliance", 32.9, 0.0, 0.0},
                                    {"blooming", 29.0, 0.0, 0.0}},
                                   5.0);
    EXPECT_EQ(verdict.finding, Finding::ambiguous);
    EXPECT_THAT(verdict.effects, ElementsAre("wall_compliance", "vessel_offset"));
}

// The best of a bad lot: an unknown effect explains as much.
TEST(Decide, FallsBackToUnknown)
{
    EXPECT_EQ(decide({{"local_push", 20.0, 0.0, 0.0}}, 18.0).finding, Finding::unknown);
    EXPECT_EQ(decide({}, 18.0).finding, Finding::unknown);
    EXPECT_EQ(decide({{"local_push", 21.1, 0.0, 0.0}}, 18.0).finding, Finding::named);
}

// What the unknown effect adds to a named one counts for the named one, and is flagged.
TEST(Decide, NamesWithAnUnexplainedRest)
{
    const Verdict verdict =
        decide({{"registration", 15.0, 12.0, 0.0}, {"blooming", 2.0, 15.0, 0.0}}, 18.0);
    EXPECT_EQ(verdict.finding, Finding::named);
    EXPECT_THAT(verdict.effects, ElementsAre("registration"));
    EXPECT_TRUE(verdict.has_unexplained_rest);
}

// The surfaces agree, but the device ends elsewhere.
TEST(Decide, CountsTheScalars)
{
    EXPECT_EQ(decide({{"blooming", 1.0, 0.0, 0.0}}, -2.0, 30.0).finding, Finding::unknown);
    EXPECT_EQ(decide({{"landing_offset", 29.0, -1.0, 0.0}}, -2.0, 30.0).finding, Finding::named);
    EXPECT_TRUE(decide({{"local_push", 29.0, -1.0, 9.0}}, -2.0, 30.0).has_unexplained_rest);
}

TEST(Decide, KeepsTheOrderOfEquals)
{
    EXPECT_THAT(decide({{"first", 9.0, -1.0, 0.0}, {"second", 9.0, -2.0, 0.0}}, 0.0).effects,
                ElementsAre("first", "second"));
}

}  // namespace braidzone
