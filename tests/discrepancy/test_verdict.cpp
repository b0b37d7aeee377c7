#include "discrepancy/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

NamedEvidence one(const std::string& effect, double evidence, double unknown, double scalars)
{
    return {.effects = {effect},
            .log_evidence = evidence,
            .log_evidence_unknown = unknown,
            .log_evidence_scalars = scalars};
}

/// The answers, effects joined by "+".
std::vector<std::string> names(const Verdict& verdict)
{
    std::vector<std::string> names;
    for (const Answer& answer : verdict.answers) {
        names.emplace_back();
        for (const std::string& effect : answer.effects)
            names.back() += (names.back().empty() ? "" : "+") + effect;
    }
    return names;
}

}  // namespace

TEST(Decide, FindsNothingMissingBelowTheBars)
{
    const Verdict verdict =
        decide({one("local_push", 2.9, 0.0, 0.0), one("blooming", 1.0, 0.0, 0.0)}, 3.3);
    EXPECT_EQ(verdict.finding, Finding::nothing_missing);
    EXPECT_THAT(verdict.answers, IsEmpty());
    EXPECT_EQ(decide({}, 0.0).finding, Finding::nothing_missing);
}

TEST(Decide, NamesTheOneThatStandsOut)
{
    const Verdict verdict =
        decide({one("blooming", 5.0, 0.0, 0.0), one("local_push", 40.0, -1.0, -1.0)}, 20.0);
    EXPECT_EQ(verdict.finding, Finding::named);
    EXPECT_THAT(names(verdict), ElementsAre("local_push"));
    EXPECT_FALSE(verdict.has_unexplained_rest);
}

// 32 - 2.6 for two effects is less than 31 for one.
TEST(Decide, ChargesForFurtherEffects)
{
    NamedEvidence two = one("local_push", 32.0, 0.0, 0.0);
    two.effects.emplace_back("blooming");
    two.log_prior = -2.6;
    EXPECT_THAT(names(decide({two, one("vessel_offset", 31.0, 0.0, 0.0)}, 5.0)),
                ElementsAre("vessel_offset", "local_push+blooming"));
}

// 20 + 10 - 5.6 with an unknown effect besides is less than 28 without one.
TEST(Decide, ChargesForAnUnknownEffectBesides)
{
    NamedEvidence with_unknown = one("local_pull", 20.0, 10.0, 0.0);
    with_unknown.unknown_price = 5.6;
    EXPECT_THAT(names(decide({with_unknown, one("axial_twist", 28.0, 0.0, 0.0)}, 5.0)),
                ElementsAre("axial_twist"));
    with_unknown.unknown_price = 0.0;
    EXPECT_THAT(names(decide({with_unknown, one("axial_twist", 28.0, 0.0, 0.0)}, 5.0)),
                ElementsAre("local_pull", "axial_twist"));
}

TEST(Decide, GivesASetWithinABayesFactorOfTwenty)
{
    const Verdict verdict =
        decide({one("vessel_offset", 30.0, 0.0, 0.0), one("wall_compliance", 32.9, 0.0, 0.0),
                one("blooming", 29.0, 0.0, 0.0)},
               5.0);
    EXPECT_EQ(verdict.finding, Finding::ambiguous);
    EXPECT_THAT(names(verdict), ElementsAre("wall_compliance", "vessel_offset"));
}

// The best of a bad lot: an unknown effect explains as much.
TEST(Decide, FallsBackToUnknown)
{
    EXPECT_EQ(decide({one("local_push", 20.0, 0.0, 0.0)}, 18.0).finding, Finding::unknown);
    EXPECT_EQ(decide({}, 18.0).finding, Finding::unknown);
    EXPECT_EQ(decide({one("local_push", 21.1, 0.0, 0.0)}, 18.0).finding, Finding::named);
}

// What the unknown effect adds to a named one counts for the named one, and is flagged.
TEST(Decide, NamesWithAnUnexplainedRest)
{
    const Verdict verdict =
        decide({one("registration", 15.0, 12.0, 0.0), one("blooming", 2.0, 15.0, 0.0)}, 18.0);
    EXPECT_EQ(verdict.finding, Finding::named);
    EXPECT_THAT(names(verdict), ElementsAre("registration"));
    EXPECT_TRUE(verdict.has_unexplained_rest);
}

// The surfaces agree, but the device ends elsewhere.
TEST(Decide, CountsTheScalars)
{
    EXPECT_EQ(decide({one("blooming", 1.0, 0.0, 0.0)}, -2.0, 30.0).finding, Finding::unknown);
    EXPECT_EQ(decide({one("landing_offset", 29.0, -1.0, 0.0)}, -2.0, 30.0).finding, Finding::named);
    EXPECT_TRUE(decide({one("local_push", 29.0, -1.0, 9.0)}, -2.0, 30.0).has_unexplained_rest);
}

TEST(Decide, KeepsTheOrderOfEquals)
{
    EXPECT_THAT(names(decide({one("first", 9.0, -1.0, 0.0), one("second", 9.0, -2.0, 0.0)}, 0.0)),
                ElementsAre("first", "second"));
}

// What a set adds to one of its effects was found to be missing: the effect alone is no answer of
// its own. Another effect that explains as much is.
TEST(Decide, LeavesOutWhatIsPartOfASet)
{
    NamedEvidence both = one("local_push", 40.0, 0.0, 0.0);
    both.effects.emplace_back("registration");
    both.fit = 2;
    const Verdict verdict = decide(
        {one("local_push", 36.0, 3.0, 0.0), one("vessel_offset", 38.0, 0.0, 0.0), both}, 5.0);
    EXPECT_EQ(verdict.finding, Finding::ambiguous);
    EXPECT_THAT(names(verdict), ElementsAre("local_push+registration", "vessel_offset"));
    EXPECT_EQ(verdict.answers.front().fit, 2u);
}

TEST(ForChoiceAmong, AsksForABayesFactorOfTwentyPerCandidate)
{
    EXPECT_NEAR(for_choice_among(15, {}).effect_bar, std::log(15.0) + 3.0, 1e-12);
    EXPECT_EQ(for_choice_among(1, {}).effect_bar, 3.0);
    EXPECT_EQ(for_choice_among(15, {}).unknown_bar, VerdictOptions{}.unknown_bar);
}

// Unknown 10. The first is 1 ahead by itself; the second is 2.9 below it; the third needs the
// unknown effect to come near; the fourth does not reach the bar of 3.
TEST(Decide, PutsKnownEffectsBesideAnUnknownOneIfAsked)
{
    const std::vector<NamedEvidence> named = {
        one("friction", 11.0, 0.0, 0.0), one("stiffening", 8.1, 0.0, 0.0),
        one("zero_offset", 4.0, 6.0, 0.0), one("density", 2.0, 8.5, 0.0)};
    EXPECT_EQ(decide(named, 10.0).finding, Finding::unknown);
    VerdictOptions options;
    options.offers_unknown = true;
    const Verdict verdict = decide(named, 10.0, 0.0, options);
    EXPECT_EQ(verdict.finding, Finding::ambiguous);
    EXPECT_THAT(names(verdict), ElementsAre("friction", "stiffening"));
    ASSERT_TRUE(verdict.unknown_lead.has_value());
    EXPECT_DOUBLE_EQ(*verdict.unknown_lead, -1.0);

    // One alone beside the unknown one is a set, too; 3 ahead of it, it is named.
    const std::vector<NamedEvidence> alone = {named.front()};
    EXPECT_EQ(decide(alone, 10.0, 0.0, options).finding, Finding::ambiguous);
    EXPECT_EQ(decide(alone, 8.0, 0.0, options).finding, Finding::named);
    EXPECT_FALSE(decide(alone, 8.0, 0.0, options).unknown_lead.has_value());
    EXPECT_EQ(decide(alone, 14.1, 0.0, options).finding, Finding::unknown);
}

// The end is off, the surface shows nothing: what explains 2.2 or more of the scalars' 5.2 may be
// it.
TEST(Decide, OffersWhatExplainsTheScalarsWhereOnlyTheyTell)
{
    VerdictOptions options;
    options.offers_unknown = true;
    options = for_choice_among(15, options);
    const std::vector<NamedEvidence> named = {one("blooming", -1.2, -3.0, 5.2),
                                              one("sliding", 5.0, -3.0, -1.0),
                                              one("local_pull", 2.3, -3.0, 1.0)};
    const Verdict verdict = decide(named, -3.0, 5.2, options);
    EXPECT_EQ(verdict.finding, Finding::ambiguous);
    EXPECT_THAT(names(verdict), ElementsAre("sliding", "local_pull"));
    EXPECT_DOUBLE_EQ(verdict.unknown_lead.value(), 5.2 - 5.0);

    options.offers_unknown = false;
    EXPECT_EQ(decide(named, -3.0, 5.2, options).finding, Finding::unknown);
    EXPECT_EQ(decide({named.front()}, -3.0, 5.2, for_choice_among(15, {})).finding,
              Finding::unknown);
}

// A strong effect of which the shape is a little other than its implementation's.
TEST(Verdict, OffersAKnownEffectThatLacksATenthOfAnUnknownOne)
{
    VerdictOptions options;
    options.offers_unknown = true;
    NamedEvidence known{.effects = {"cone"}, .log_evidence = 91.0};
    const Verdict verdict = decide({known}, 100.0, 0.0, options);
    EXPECT_EQ(verdict.finding, Finding::ambiguous);
    EXPECT_THAT(names(verdict), ElementsAre("cone"));
    ASSERT_TRUE(verdict.unknown_lead.has_value());
    EXPECT_DOUBLE_EQ(*verdict.unknown_lead, 9.0);
    known.log_evidence = 89.0;
    EXPECT_EQ(decide({known}, 100.0, 0.0, options).finding, Finding::unknown);
}

}  // namespace braidzone
