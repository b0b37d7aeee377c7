#include "core/error.hpp"
#include "discrepancy/blind/plan.hpp"
#include "discrepancy/blind/score.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace braidzone::blind {
namespace {

using testing::HasSubstr;

CaseTruth single(const std::string& name, std::map<std::string, double> values = {})
{
    return {"single", {{name, hidden::EffectSize::medium, std::move(values)}}};
}

Answer names(std::vector<std::vector<std::string>> sets, bool has_rest = false)
{
    return {.finding = sets.size() == 1 ? "named" : "ambiguous",
            .sets = std::move(sets),
            .leaves_doubt = has_rest};
}

const Answer nothing{.finding = "nothing_missing"};
const Answer something{.finding = "unknown"};

}  // namespace

// No case of n: the upper bound u solves (1 - u)^n = 0.025. Five of ten: 0.187 to 0.813 (Clopper
// and Pearson's tables).
TEST(ClopperPearson, HoldsItsClosedForms)
{
    const Bounds none = clopper_pearson({0, 150});
    EXPECT_DOUBLE_EQ(none.lower, 0.0);
    EXPECT_NEAR(none.upper, 1.0 - std::pow(0.025, 1.0 / 150.0), 1e-9);
    const Bounds all = clopper_pearson({20, 20});
    EXPECT_NEAR(all.lower, std::pow(0.025, 1.0 / 20.0), 1e-9);
    EXPECT_DOUBLE_EQ(all.upper, 1.0);
    const Bounds half = clopper_pearson({5, 10});
    EXPECT_NEAR(half.lower, 0.187, 1e-3);
    EXPECT_NEAR(half.upper, 0.813, 1e-3);
    EXPECT_DOUBLE_EQ(clopper_pearson({0, 0}).upper, 1.0);
}

TEST(BlindScore, CountsSingleEffects)
{
    Answer right = names({{"blooming"}, {"vessel_offset"}});
    right.fits["blooming"] = {.log_evidence = 9.0,
                              .values = {{"blooming", 0.1e-3}},
                              .sd = {{"blooming", 0.01e-3}},
                              .rms_after = 0.04e-3};
    right.rms_before = 0.1e-3;
    right.rms_after = 0.05e-3;
    const Score score = score_of({{single("blooming", {{"blooming", 0.116e-3}}), right},
                                  {single("blooming"), names({{"vessel_offset"}, {"blooming"}})},
                                  {single("blooming"), something},
                                  {single("blooming"), nothing}});
    const SingleScore& blooming = score.singles.at("blooming");
    EXPECT_EQ(blooming.detected.count, 3);
    EXPECT_EQ(blooming.detected.of, 4);
    EXPECT_EQ(blooming.first.count, 1);
    EXPECT_EQ(blooming.first.of, 3);
    EXPECT_EQ(blooming.first_of_named.of, 2);
    EXPECT_EQ(blooming.in_set.count, 2);
    EXPECT_EQ(blooming.among_names.count, 2);
    EXPECT_EQ(blooming.covered.count, 1);  // 1.6 standard deviations off
    EXPECT_EQ(blooming.covered.of, 1);
    EXPECT_THAT(blooming.rms_oracle, testing::ElementsAre(0.04e-3));
    EXPECT_EQ(score.confusion.at("blooming").at("unknown"), 1);
    EXPECT_EQ(score.confusion.at("blooming").at("none"), 1);
    // (0.1^2 - 0.05^2) / (0.1^2 - 0.04^2) = 0.893
    EXPECT_THAT(score_text(score), HasSubstr("0.100 / 0.050 / 0.040 | 0.89 |"));
}

TEST(BlindScore, MeasuresPlaces)
{
    Answer answer = names({{"local_push"}});
    answer.fits["local_push"] = {.values = {{"centre", 15.4e-3}}, .sd = {{"centre", 0.1e-3}}};
    const Score score = score_of({{single("local_push", {{"centre", 15e-3}}), answer}});
    ASSERT_EQ(score.all_singles.location_errors.size(), 1u);
    EXPECT_NEAR(score.all_singles.location_errors.front(), 0.4e-3, 1e-12);
    EXPECT_EQ(score.all_singles.covered.count, 0);
}

TEST(BlindScore, CountsFalseAlarmsAndUnflaggedNames)
{
    const CaseTruth none{"none", {}};
    const CaseTruth dent{"outside", {{"dent"}}};
    const Score score = score_of({{none, nothing},
                                  {none, something},
                                  {dent, names({{"local_pull"}})},
                                  {dent, names({{"local_pull"}}, true)},
                                  {dent, something},
                                  {dent, {.finding = "error", .error = "too few patches"}}});
    EXPECT_EQ(score.false_alarm.count, 1);
    EXPECT_EQ(score.false_alarm.of, 2);
    EXPECT_EQ(score.wrong_without_flag.count, 1);
    EXPECT_EQ(score.wrong_without_flag.of, 4);
    EXPECT_EQ(score.errors, 1);
}

TEST(BlindScore, CountsPairs)
{
    const CaseTruth pair{"pair", {{"local_push"}, {"blooming"}}};
    const Score score = score_of({{pair, names({{"blooming", "local_push"}})},
                                  {pair, names({{"blooming"}})},
                                  {pair, names({{"blooming", "sliding"}})},
                                  {pair, names({{"sliding"}, {"blooming", "local_push"}})},
                                  {pair, something}});
    EXPECT_EQ(score.pairs.both.count, 1);
    EXPECT_EQ(score.pairs.one.count, 2);
    EXPECT_EQ(score.pairs.wrong.count, 2);
    EXPECT_EQ(score.pairs.in_set.count, 2);
    EXPECT_EQ(score.pairs.one.of, 5);
}

TEST(BlindScore, SortsCasesByTheFainterEffect)
{
    const CaseTruth plain{"pair", {{"local_push"}, {"blooming"}}, {9.0, 6.0}};
    const CaseTruth hardly{"pair", {{"braid_ratio"}, {"blooming"}}, {0.7, 11.0}};
    const CaseTruth faint{"single", {{"blooming"}}, {3.9}};
    const Score score = score_of({{plain, names({{"blooming", "local_push"}})},
                                  {hardly, names({{"blooming"}})},
                                  {faint, nothing},
                                  {single("blooming"), names({{"blooming"}})}});
    EXPECT_EQ(score.pairs.both.of, 2);
    EXPECT_EQ(score.pairs_by_detectability[3].both.count, 1);
    EXPECT_EQ(score.pairs_by_detectability[3].both.of, 1);
    EXPECT_EQ(score.pairs_by_detectability[0].one.count, 1);
    EXPECT_EQ(score.singles_by_detectability[1].detected.of, 1);
    EXPECT_EQ(score.singles_by_detectability[3].detected.of, 0);
    EXPECT_EQ(score.all_singles.detected.of, 2);
    EXPECT_THAT(score_text(score), HasSubstr("| 3 to 4 | 0/1 = 0.0 % "));
}

TEST(BlindScore, CountsASingleEffectThatIsNamedWithAnother)
{
    const Score score = score_of({{single("blooming"), names({{"blooming", "registration"}})}});
    EXPECT_EQ(score.all_singles.in_set.count, 0);
    EXPECT_EQ(score.all_singles.among_names.count, 1);
}

TEST(BlindScore, FallsToChanceWithShuffledLabels)
{
    std::vector<ScoredCase> cases;
    for (int i = 0; i < 400; ++i) {
        const std::string name = "effect_" + std::to_string(i % 8);
        cases.push_back({single(name), names({{name}})});
    }
    EXPECT_EQ(score_of(cases).all_singles.first.count, 400);
    // One in eight by chance, 50 +- 6.6: four standard deviations.
    EXPECT_NEAR(score_of(shuffled(cases, 5)).all_singles.first.count, 50, 27);
}

TEST(BlindPlan, HoldsWhatIsAsked)
{
    const std::vector<PlannedCase> plan = make_plan({.per_effect = 3,
                                                     .none = 4,
                                                     .outside = 10,
                                                     .pairs = 20,
                                                     .effects = {"local_push", "blooming"}},
                                                    1);
    std::map<std::string, int> kinds, sizes;
    for (const PlannedCase& one : plan) {
        ++kinds[one.kind];
        if (one.kind == "single") ++sizes[std::string(name_of(one.effects.front().size))];
        if (one.kind == "pair") {
            ASSERT_EQ(one.effects.size(), 2u);
            EXPECT_NE(one.effects[0].name, one.effects[1].name);
        }
    }
    EXPECT_EQ(kinds, (std::map<std::string, int>{
                         {"none", 4}, {"outside", 10}, {"pair", 20}, {"single", 6}}));
    EXPECT_EQ(sizes, (std::map<std::string, int>{{"medium", 2}, {"strong", 2}, {"weak", 2}}));
    EXPECT_THROW(make_plan({.per_effect = 1, .effects = {"luck"}}, 1), InputError);
}

TEST(BlindPlan, DrawsAnotherPairOfTheSameSizes)
{
    const PlannedCase pair{
        "pair",
        {{"local_push", hidden::EffectSize::medium}, {"braid_ratio", hidden::EffectSize::strong}}};
    std::set<std::string> firsts;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const PlannedCase other = another_pair(pair, seed);
        ASSERT_EQ(other.effects.size(), 2u);
        EXPECT_EQ(other.kind, "pair");
        EXPECT_NE(other.effects[0].name, other.effects[1].name);
        EXPECT_EQ(other.effects[0].size, hidden::EffectSize::medium);
        EXPECT_EQ(other.effects[1].size, hidden::EffectSize::strong);
        firsts.insert(other.effects[0].name);
    }
    EXPECT_GT(firsts.size(), 5u);
}

TEST(BlindFiles, KeepTruthsAndAnswers)
{
    const test::TemporaryFolder folder;
    CaseTruth truth = single("local_push", {{"centre", 15e-3}});
    truth.detectability = {4.25};
    std::ofstream(folder.path() / "truth.json") << truth_text(truth, 42);
    const CaseTruth read = read_truth(folder.path() / "truth.json");
    EXPECT_EQ(read.kind, "single");
    EXPECT_EQ(read.effects.front().name, "local_push");
    EXPECT_EQ(read.effects.front().size, hidden::EffectSize::medium);
    EXPECT_EQ(read.effects.front().values, truth.effects.front().values);
    EXPECT_EQ(read.detectability, truth.detectability);

    Answer answer = names({{"local_push", "blooming"}, {"sliding"}}, true);
    answer.fits["sliding"] = {.log_evidence = 3.0,
                              .values = {{"friction", 0.1}, {"free", std::nan("")}},
                              .sd = {{"friction", 0.01}},
                              .rms_after = 0.05e-3};
    answer.named = {{.effects = {"sliding"}, .log_evidence = 3.0, .log_evidence_unknown = -1.5}};
    std::ofstream(folder.path() / "answer.json") << answer_text(answer);
    const Answer back = read_answer(folder.path() / "answer.json");
    EXPECT_EQ(back.sets, answer.sets);
    ASSERT_EQ(back.named.size(), 1u);
    EXPECT_EQ(back.named.front().effects, std::vector<std::string>{"sliding"});
    EXPECT_EQ(back.named.front().log_evidence_unknown, -1.5);
    EXPECT_TRUE(back.leaves_doubt);
    EXPECT_EQ(first_answer(back), "blooming+local_push");
    EXPECT_EQ(back.fits.at("sliding").values, (std::map<std::string, double>{{"friction", 0.1}}));
    EXPECT_DOUBLE_EQ(back.fits.at("sliding").rms_after, 0.05e-3);
}

TEST(BlindFiles, KeepCases)
{
    const test::TemporaryFolder folder;
    const hidden::HiddenCase made = hidden::random_case({}, 3);
    const hidden::FurtherData further = hidden::further_data(made, 4);
    write_case(made, further, folder.path() / "0001");
    EXPECT_THAT(cases_in(folder.path()), testing::ElementsAre("0001"));
    const CaseData data = read_case(folder.path() / "0001");
    EXPECT_NEAR(data.model.landing_distal, made.belief.landing, 1e-9);
    EXPECT_NEAR(data.model.device.braid_ratio, made.belief.device.braid_ratio, 1e-12);
    ASSERT_EQ(data.points.size(), made.scan.points.size());
    EXPECT_LT((data.points.back() - made.scan.points.back()).norm(), 1e-6);
    EXPECT_NEAR(data.scalars.values[1]->value, made.scan.ends.values[1]->value, 5.1e-6);
    EXPECT_NEAR(data.lumen.centerline.length(), 30e-3, 1e-5);
    EXPECT_TRUE(data.density.places.empty());
    EXPECT_FALSE(data.scalars.contact_force);

    const CaseData more = read_case(folder.path() / "0001", true);
    EXPECT_NEAR(more.scalars.contact_force->force.value, further.force.force.value, 5.1e-6);
    ASSERT_EQ(more.density.places.size(), further.density.places.size());
    EXPECT_NEAR(more.density.places.back().value, further.density.places.back().value, 501.0);
    EXPECT_LT((more.density.places.back().point - further.density.places.back().point).norm(),
              1e-6);
}

}  // namespace braidzone::blind
