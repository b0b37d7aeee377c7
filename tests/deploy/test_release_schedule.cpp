#include "core/error.hpp"
#include "deploy/release_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace braidzone {

TEST(RingPositions, AreNominalWithoutWindows)
{
    const std::vector<double> positions = ring_positions({}, 18e-3, 0.1e-3, 101);
    ASSERT_EQ(positions.size(), 101u);
    EXPECT_DOUBLE_EQ(positions.front(), 18e-3);
    EXPECT_NEAR(positions.back(), 8e-3, 1e-15);
}

// From 20 mm: 6 mm at nominal spacing down to 14 mm; the remaining 14 mm of braid would need
// 14 * 0.34 = 4.76 mm at lambda = 0.34, and the window is 6 mm long: it ends at 9.24 mm.
TEST(RingPositions, ShortenADevicePushedInAWindow)
{
    const ReleaseSchedule push{{{.from = 8e-3, .to = 14e-3, .spacing = 0.34}}};
    const std::vector<double> positions = ring_positions(push, 20e-3, 0.1e-3, 201);
    EXPECT_NEAR(positions.back(), 9.24e-3, 1e-12);
}

// 20 mm of braid from 20 mm: 2 mm free, window 18 to 17 mm holds 1 / 0.5 = 2 mm, 16 mm remain.
TEST(RingPositions, GoOnAtNominalSpacingBelowTheWindow)
{
    const ReleaseSchedule push{{{.from = 17e-3, .to = 18e-3, .spacing = 0.5}}};
    const std::vector<double> positions = ring_positions(push, 20e-3, 0.1e-3, 201);
    EXPECT_NEAR(positions.back(), 1e-3, 1e-12);
}

// The braid used up between the ends does not depend on how finely it is cut, although windows
// begin and end between rings.
TEST(RingPositions, DoNotDependOnTheFinenessOfTheLattice)
{
    const ReleaseSchedule two{{{.from = 5.03e-3, .to = 7.77e-3, .spacing = 0.4},
                               {.from = 11.01e-3, .to = 13.57e-3, .spacing = 1.3}}};
    const double coarse = ring_positions(two, 18e-3, 0.5e-3, 31).back();
    const double fine = ring_positions(two, 18e-3, 0.05e-3, 301).back();
    EXPECT_NEAR(coarse, fine, 1e-12);
}

// lambda = 0.5 + 0.1 / mm * s: the braid between s and 10 mm is 10 mm ln(lambda(10) / lambda(s)).
// 20 rings of 0.5 mm are 9.5 mm: lambda = 1.5 exp(-0.95) = 0.580112, s = 0.801116 mm.
TEST(RingPositions, IntegrateATableExactly)
{
    const ReleaseSchedule schedule{.windows = {}, .table = {{0.0, 0.5}, {10e-3, 1.5}}};
    const std::vector<double> coarse = ring_positions(schedule, 10e-3, 0.5e-3, 20);
    EXPECT_NEAR(coarse.back(), 10e-3 * (1.5 * std::exp(-0.95) - 0.5), 1e-15);
    EXPECT_NEAR(coarse.back(), 0.801116e-3, 1e-9);
    const std::vector<double> fine = ring_positions(schedule, 10e-3, 0.05e-3, 191);
    EXPECT_NEAR(fine.back(), coarse.back(), 1e-14);
}

// 2 mm of braid at lambda = 1.5 beyond the table's end take 3 mm, then 0.4 below it takes over.
TEST(RingPositions, HoldATableBeyondItsEnds)
{
    const ReleaseSchedule schedule{.windows = {}, .table = {{5e-3, 1.5}, {6e-3, 1.5}}};
    EXPECT_NEAR(ring_positions(schedule, 10e-3, 1e-3, 6).back(), 2.5e-3, 1e-15);
}

// Force-free spacing of 1.2 everywhere, halved in the window: 3 mm of braid from 10 mm to 8 mm
// (1.667 mm of braid) and on for 1.333 mm of braid at 0.6.
TEST(RingPositions, MultiplyTheTableByTheWindows)
{
    const ReleaseSchedule schedule{.windows = {{.from = 2e-3, .to = 8e-3, .spacing = 0.5}},
                                   .table = {{0.0, 1.2}, {10e-3, 1.2}}};
    EXPECT_NEAR(ring_positions(schedule, 10e-3, 0.1e-3, 31).back(),
                8e-3 - 0.6 * (3e-3 - 2e-3 / 1.2), 1e-14);
}

TEST(Validate, RefusesReversedOverlappingAndImpossibleWindows)
{
    EXPECT_THROW(validate(ReleaseSchedule{{{.from = 2e-3, .to = 1e-3, .spacing = 1.0}}}),
                 ConfigError);
    EXPECT_THROW(validate(ReleaseSchedule{{{.from = 1e-3, .to = 2e-3, .spacing = 0.0}}}),
                 ConfigError);
    EXPECT_THROW(validate(ReleaseSchedule{{{.from = 1e-3, .to = 3e-3, .spacing = 0.5},
                                           {.from = 2e-3, .to = 4e-3, .spacing = 0.5}}}),
                 ConfigError);
    EXPECT_NO_THROW(validate(ReleaseSchedule{
        {{.from = 1e-3, .to = 2e-3, .spacing = 0.5}, {.from = 2e-3, .to = 4e-3, .spacing = 1.5}}}));
}

namespace {

std::string refusal(const ReleaseSchedule& schedule)
{
    try {
        validate(schedule);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST(Validate, RefusesATableBesideAnotherSchedule)
{
    ReleaseSchedule schedule{.windows = {}, .table = {{0.0, 1.0}, {10e-3, 1.5}}};
    EXPECT_EQ(refusal(schedule), "accepted");
    schedule.sliding = 1.0;
    EXPECT_EQ(refusal(schedule),
              "spacing_table is the whole schedule; sliding, which release = \"force_free\" is in "
              "full, cannot stand beside it: keep one of them");
    schedule.sliding = 0.0;
    schedule.windows = {{.from = 1e-3, .to = 2e-3, .spacing = 0.5}};
    EXPECT_EQ(refusal(schedule),
              "spacing_table is the whole schedule; push_pull cannot stand beside it: keep one of "
              "them");
}

TEST(Validate, RefusesASlidingThatIsNoShare)
{
    EXPECT_EQ(refusal({.sliding = 0.3}), "accepted");
    EXPECT_EQ(refusal({.sliding = 1.1}),
              "sliding = 1.1; allowed are 0 (rings stay at the nominal spacing) to 1 (they take "
              "the force-free spacing)");
}

TEST(Validate, RefusesATableThatIsNoFunctionOfPlace)
{
    EXPECT_EQ(refusal({.windows = {}, .table = {{2e-3, 1.0}, {1e-3, 1.5}}}),
              "spacing_table: 1 mm follows 2 mm; arc lengths must increase");
    EXPECT_EQ(refusal({.windows = {}, .table = {{1e-3, 1.0}, {2e-3, 4.5}}}),
              "spacing_table: lambda = 4.5 at 2 mm; allowed are 0.05 to 4 times the nominal "
              "spacing");
}

}  // namespace braidzone
