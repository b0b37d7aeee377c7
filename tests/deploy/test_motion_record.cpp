#include "deploy/motion_record.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

namespace {

/// Records a motion of which the shape is the number of the step.
std::vector<MotionRecord<int>::Entry> record_of(int num_wanted, int num_steps)
{
    MotionRecord<int> record(num_wanted);
    for (int step = 0; step < num_steps; ++step) {
        if (record.wants(step)) record.add(step, 2 * step, step);
    }
    return record.finish(num_steps, 2 * num_steps, num_steps);
}

}  // namespace

TEST(MotionRecord, KeepsNothingUnlessFramesAreWanted)
{
    EXPECT_TRUE(record_of(0, 100).empty());
}

TEST(MotionRecord, KeepsTheStartAndTheEnd)
{
    const auto frames = record_of(7, 12345);
    EXPECT_EQ(frames.front().step, 0);
    EXPECT_EQ(frames.back().step, 12345);
    EXPECT_EQ(frames.back().shape, 12345);
    EXPECT_EQ(frames.back().num_released, 24690);
}

TEST(MotionRecord, GivesOneFrameAtTheEndIfOneIsWanted)
{
    const auto frames = record_of(1, 500);
    ASSERT_EQ(frames.size(), 1u);
    EXPECT_EQ(frames[0].step, 500);
}

// At least four times as many shapes as are wanted are kept, so that one lies within an eighth of
// a frame's distance of where it should be.
TEST(MotionRecord, KeepsTheWantedNumberAtEqualDistances)
{
    for (int num_steps : {200, 999, 12345}) {
        const auto frames = record_of(11, num_steps);
        ASSERT_EQ(frames.size(), 11u) << num_steps;
        for (int i = 0; i < 11; ++i) {
            const auto& frame = frames[static_cast<std::size_t>(i)];
            EXPECT_NEAR(frame.step, 0.1 * num_steps * i, 0.1 * num_steps / 8.0 + 1.0);
            EXPECT_EQ(frame.shape, frame.step);
        }
    }
}

TEST(MotionRecord, GivesEveryStepIfThereAreFewer)
{
    const auto frames = record_of(20, 5);
    ASSERT_EQ(frames.size(), 6u);
    for (int i = 0; i < 6; ++i)
        EXPECT_EQ(frames[static_cast<std::size_t>(i)].step, i);
}

}  // namespace braidzone
