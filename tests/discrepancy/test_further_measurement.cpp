#include "core/error.hpp"
#include "discrepancy/further_measurement.hpp"
#include "support/linear_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

/// Candidates a = (1, 1, 0, 0), b = (1, 1, 2, 0), c = (1, 1, 0, 0.1): alike in the first two rows,
/// which are measured; the third row tells b from the others, the fourth hardly c from a.
test::LinearProblem alike_in_two_rows()
{
    test::LinearProblem linear;
    linear.fingerprints.resize(4, 3);
    linear.fingerprints << 1, 1, 1,  //
        1, 1, 1,                     //
        0, 2, 0,                     //
        0, 0, 0.1;
    linear.data = Eigen::VectorXd::Zero(4);
    return linear;
}

EffectFit fit_of(const DiagnosisProblem& problem, std::size_t candidate, double size,
                 double log_evidence)
{
    EffectFit fit;
    FittedEffect effect;
    effect.candidate = candidate;
    effect.name = problem.candidates[candidate].name;
    effect.parameters = problem.candidates[candidate].parameters;
    effect.values = {size};
    fit.effects = {effect};
    fit.x = Eigen::VectorXd::Constant(1, size / effect.parameters.front().prior_sd);
    fit.log_evidence = log_evidence;
    return fit;
}

const std::vector<FurtherChannel> two_channels = {{"fourth", "the fourth row", {3}},
                                                  {"third", "the third row", {2}}};

FurtherMeasurement told(const std::vector<std::size_t>& candidates)
{
    const DiagnosisProblem problem = alike_in_two_rows().problem();
    std::vector<EffectFit> answers;
    for (const std::size_t candidate : candidates)
        answers.push_back(fit_of(problem, candidate, 6.0, 10.0 - static_cast<double>(candidate)));
    return further_measurement(problem, {0, 1}, two_channels, answers);
}

}  // namespace

// Both of size A = 6 leave (0, 0, 2 A, 0) between them. With noise 1 and the prior's sd of 10 the
// first two rows tell a size to P = 1 / (2 + 1/100). If a is true, b could still explain some of
// the third row: (2 A)^2 / (1 + 2^2 P) = A^2 4 / 2.99; if b is true, a none of it: (2 A)^2. The
// smaller counts, but for the prior's pull on a size of 6 of 1 %.
TEST(FurtherMeasurement, AddsWhatTheOtherAnswerCannotExplain)
{
    const FurtherMeasurement found = told({0, 1});
    ASSERT_EQ(found.pairs.size(), 1u);
    EXPECT_NEAR(found.pairs[0].now, std::sqrt(2.0), 1e-12);  // ln B 10 and 9
    EXPECT_NEAR(found.pairs[0].added[1], 6.0 * std::sqrt(4.0 / (1.0 + 4.0 / 2.01)), 0.06);
    EXPECT_NEAR(found.pairs[0].added[0], 0.0, 1e-6);
    EXPECT_NEAR(found.pairs[0].with(1), std::hypot(found.pairs[0].now, found.pairs[0].added[1]),
                1e-12);
    EXPECT_EQ(found.best, 1u);
    EXPECT_TRUE(separates(found.pairs[0], 1));
    EXPECT_FALSE(separates(found.pairs[0], 0));
}

TEST(FurtherMeasurement, FindsTheChannelThatSeparatesMostPairs)
{
    const FurtherMeasurement found = told({0, 1, 2});
    ASSERT_EQ(found.pairs.size(), 3u);
    EXPECT_EQ(found.best, 1u);
    const SeparatedPair& hardest = hardest_pair(found, 1);
    EXPECT_EQ(found.answers[hardest.first], "a");
    EXPECT_EQ(found.answers[hardest.second], "c");
}

// a and c differ by 0.6 in the fourth row alone, which is the more expensive one here.
TEST(FurtherMeasurement, TellsTheNearestWhereNoneSeparates)
{
    const FurtherMeasurement found = told({0, 2});
    EXPECT_EQ(found.best, 0u);
    EXPECT_NEAR(found.pairs[0].added[0], 0.6, 0.01);
    EXPECT_FALSE(separates(found.pairs[0], 0));
}

TEST(FurtherMeasurement, IsNoneForOneAnswer)
{
    const FurtherMeasurement found = told({1});
    EXPECT_TRUE(found.pairs.empty());
    EXPECT_FALSE(found.best.has_value());
}

TEST(FurtherMeasurement, LeavesOutAnAnswerThatCannotBeSimulated)
{
    DiagnosisProblem problem = alike_in_two_rows().problem();
    std::vector<EffectFit> answers;
    for (const std::size_t candidate : {0, 1, 2})
        answers.push_back(fit_of(problem, candidate, 6.0, 0.0));
    problem.residuals = [residuals = problem.residuals](const std::vector<ActiveEffect>& effects) {
        if (effects.front().candidate == 1) throw GeometryError("the device breaks");
        return residuals(effects);
    };
    const FurtherMeasurement found = further_measurement(problem, {0, 1}, two_channels, answers);
    ASSERT_EQ(found.pairs.size(), 1u);
    EXPECT_EQ(found.pairs[0].second, 2u);
}

}  // namespace braidzone
