// The whole search on measurements that are linear in the effects' sizes
// (support/linear_problem.hpp).

#include "discrepancy/explanation.hpp"
#include "discrepancy/held_out.hpp"
#include "discrepancy/shape_error.hpp"
#include "support/linear_problem.hpp"

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace braidzone {
namespace {

using testing::ElementsAre;

/// Twelve blocks of five places.
std::vector<std::vector<int>> blocks()
{
    std::vector<std::vector<int>> folds;
    for (int first = 0; first < 60; first += 5) {
        folds.emplace_back(5);
        std::iota(folds.back().begin(), folds.back().end(), first);
    }
    return folds;
}

double rms(const Eigen::VectorXd& values)
{
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace

TEST(Explain, NamesOneOfThree)
{
    const DiagnosisProblem problem = test::three_bumps(0.0, 4.0, 0.0, 1).problem();
    const Explanation found = explain(problem);
    EXPECT_EQ(found.verdict.finding, Finding::named);
    ASSERT_EQ(found.verdict.answers.size(), 1u);
    EXPECT_THAT(found.verdict.answers[0].effects, ElementsAre("b"));
    ASSERT_TRUE(found.best.has_value());
    EXPECT_EQ(*found.best, 1u);
}

TEST(Explain, NamesTwoTogether)
{
    const DiagnosisProblem problem = test::three_bumps(3.0, 0.0, -4.0, 2).problem();
    const Explanation found = explain(problem);
    EXPECT_EQ(found.verdict.finding, Finding::named);
    ASSERT_EQ(found.verdict.answers.size(), 1u);
    EXPECT_THAT(found.verdict.answers[0].effects, testing::UnorderedElementsAre("a", "c"));
}

// Half the evidence is that of normal data, in closed form; the other half, with errors of the
// shapes (`evidence_with_shape_error`), may add to it what it likes, but a set is not weighed in
// the order in which its effects were found.
TEST(Explain, WeighsASetAtOnceWhereShapesAreDoubted)
{
    const test::LinearProblem linear = test::three_bumps(3.0, 0.0, -4.0, 2);
    const DiagnosisProblem problem = linear.problem();
    ExplainOptions options;
    options.doubts_shapes = true;
    const Explanation found = explain(problem, options);
    ASSERT_TRUE(found.best.has_value());
    const EffectFit& both = found.fits[*found.best];
    ASSERT_EQ(both.effects.size(), 2u);
    Eigen::MatrixXd bumps(linear.data.size(), 2);
    bumps << linear.fingerprints.col(0), linear.fingerprints.col(2);
    const Eigen::MatrixXd covariance =
        Eigen::MatrixXd::Identity(linear.data.size(), linear.data.size()) +
        100.0 * bumps * bumps.transpose();
    const double exact = 0.5 * linear.data.squaredNorm() -
                         0.5 * linear.data.dot(covariance.llt().solve(linear.data)) -
                         0.5 * std::log(covariance.determinant());
    EXPECT_NEAR(both.log_evidence_together, exact, 1e-6);
    const double doubting =
        evidence_with_shape_error(problem, Whitening(problem.covariance), linear.data, both, 0.1);
    EXPECT_NEAR(both.log_evidence, std::log(0.5 * std::exp(exact) + 0.5 * std::exp(doubting)),
                1e-6);
}

TEST(Explain, NamesThreeTogetherButNoMoreThanAllowed)
{
    const DiagnosisProblem problem = test::three_bumps(3.0, 5.0, -4.0, 3).problem();
    const Explanation found = explain(problem);
    ASSERT_EQ(found.verdict.answers.size(), 1u);
    EXPECT_EQ(found.verdict.answers[0].effects.size(), 3u);
    ExplainOptions at_most_two;
    at_most_two.search.most_effects = 2;
    for (const EffectFit& fit : explain(problem, at_most_two).fits)
        EXPECT_LE(fit.effects.size(), 2u);
}

// P(B > b) <= 1 / b for any Bayes factor: of 100 sets of noise and bars of 3 e^3 and e^3.4 no more
// than 3 x 1.7 + 3.3 alarms are expected; 18 have a chance far below 1 %.
TEST(Explain, IsRarelyAlarmedByNoise)
{
    int alarms = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const Explanation found = explain(test::three_bumps(0.0, 0.0, 0.0, 100 + seed).problem());
        alarms += found.verdict.finding == Finding::nothing_missing ? 0 : 1;
    }
    EXPECT_LT(alarms, 18);
}

// Two candidates that do the same: an answer that names both, alone each.
TEST(Explain, GivesASetWhereTwoDoTheSame)
{
    test::LinearProblem linear = test::three_bumps(0.0, 4.0, 0.0, 4);
    linear.fingerprints.col(2) = linear.fingerprints.col(1);
    const Explanation found = explain(linear.problem());
    EXPECT_EQ(found.verdict.finding, Finding::ambiguous);
    ASSERT_EQ(found.verdict.answers.size(), 2u);
    EXPECT_THAT(found.verdict.answers[0].effects, ElementsAre("b"));
    EXPECT_THAT(found.verdict.answers[1].effects, ElementsAre("c"));
}

TEST(Explain, SaysUnknownOfABumpThatNoCandidateMakes)
{
    test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 8);
    linear.data += 4.0 * test::bump(linear.data.size(), 20.0, 3.0);
    const Explanation found = explain(linear.problem());
    EXPECT_TRUE(found.verdict.finding == Finding::unknown || found.verdict.has_unexplained_rest);
    EXPECT_FALSE(found.verdict.finding == Finding::nothing_missing);
    Eigen::Index highest = 0;
    found.unexplained.maxCoeff(&highest);
    EXPECT_NEAR(static_cast<double>(highest), 20.0, 2.0);
}

// With labels shuffled, that is with the data of another place, the name does not follow.
TEST(Explain, DoesNotNameWhatLiesElsewhere)
{
    test::LinearProblem linear = test::three_bumps(0.0, 4.0, 0.0, 9);
    const Eigen::VectorXd data = linear.data;
    for (Eigen::Index i = 0; i < data.size(); ++i)
        linear.data[i] = data[(i + 10) % data.size()];
    const Explanation found = explain(linear.problem());
    for (const Answer& answer : found.verdict.answers)
        EXPECT_TRUE(answer.effects != std::vector<std::string>{"b"} ||
                    found.verdict.has_unexplained_rest);
}

// Left out, a block has the noise of 1 as its gap once the effect is in the model: of the data that
// it was not fitted to. The prediction with the right effect in all folds is about the same.
TEST(HeldOutGap, FallsToTheNoiseWhereTheEffectIsKnown)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 6.0, 0.0, 11);
    const DiagnosisProblem problem = linear.problem();
    const Explanation found = explain(problem);
    const HeldOutGap gap = held_out_gap(problem, found, blocks(), 0.0);
    EXPECT_NEAR(rms(gap.before), rms(linear.data),
                1e-12);  // without nuisances nothing is taken out
    EXPECT_LT(rms(gap.after), 1.3);
    EXPECT_GT(rms(gap.before), 1.8);
    EXPECT_NEAR(rms(gap.after), rms(gap.of_fits[1]), 0.05);
    EXPECT_EQ(gap.choices.size(), 12u);
    EXPECT_GE(gap.num_same, 11);
    EXPECT_TRUE(gap.confirms());
}

// A fold's prediction by hand: the size of b from all places but the block's and those within the
// buffer, a = F'd / (F'F + 1/100) over those.
TEST(HeldOutGap, LearnsFromTheOtherBlocksAlone)
{
    const test::LinearProblem linear = test::three_bumps(0.0, 6.0, 0.0, 12);
    const DiagnosisProblem problem = linear.problem();
    const HeldOutGap gap = held_out_gap(problem, explain(problem), blocks(), 2.0);
    double along = 0.0, square = 0.01;
    for (Eigen::Index i = 0; i < 60; ++i) {
        if (i >= 23 && i <= 31) continue;  // block 25 to 29 and a buffer of 2
        along += linear.fingerprints(i, 1) * linear.data[i];
        square += linear.fingerprints(i, 1) * linear.fingerprints(i, 1);
    }
    for (Eigen::Index i = 25; i < 30; ++i) {
        EXPECT_NEAR(gap.of_fits[1][i], linear.data[i] - along / square * linear.fingerprints(i, 1),
                    1e-6);
    }
}

TEST(HeldOutGap, OfNoiseChoosesNothing)
{
    const DiagnosisProblem problem = test::three_bumps(0.0, 0.0, 0.0, 13).problem();
    const HeldOutGap gap = held_out_gap(problem, explain(problem), blocks(), 0.0);
    EXPECT_THAT(gap.choices, testing::Each("none"));
    EXPECT_EQ(gap.log_score_gain, 0.0);
    EXPECT_EQ(gap.before, gap.after);
    EXPECT_FALSE(gap.confirms());
}

// An offset of all places is a nuisance, N = 100 1 1': its mean over the other places is taken out.
TEST(HeldOutGap, TakesOutWhatANuisanceDoes)
{
    test::LinearProblem linear = test::three_bumps(0.0, 0.0, 0.0, 14);
    linear.data.array() += 8.0;
    DiagnosisProblem problem = linear.problem();
    problem.nuisance = Eigen::MatrixXd::Constant(60, 60, 100.0);
    problem.covariance += problem.nuisance;
    const HeldOutGap gap = held_out_gap(problem, explain(problem), blocks(), 0.0);
    const double rest = linear.data.tail(55).sum() * 100.0 / (1.0 + 55.0 * 100.0);
    for (Eigen::Index i = 0; i < 5; ++i)
        EXPECT_NEAR(gap.before[i], linear.data[i] - rest, 1e-9);
    const Eigen::MatrixXd rows = held_out_rows(problem, blocks(), 0.0);
    EXPECT_LT((rows * linear.data - gap.before).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace braidzone
