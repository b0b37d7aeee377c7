#include "core/error.hpp"
#include "deploy/release_schedule.hpp"

#include <gtest/gtest.h>

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

}  // namespace braidzone
