#include "cli/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace braidzone {
namespace {

TEST(Progress, TimesStagesInTheOrderOfTheirBeginning)
{
    Progress progress(true);
    progress.begin("vessel", "reading");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    progress.begin("deploy", "deploying");
    progress.end();
    ASSERT_EQ(progress.times().size(), 2u);
    EXPECT_EQ(progress.times()[0].stage, "vessel");
    EXPECT_EQ(progress.times()[1].stage, "deploy");
    // A sleep lasts as long as asked for or longer.
    EXPECT_GE(progress.seconds("vessel"), 0.020);
    EXPECT_LT(progress.seconds("deploy"), progress.seconds("vessel"));
}

TEST(Progress, AddsUpAStageThatIsBegunTwice)
{
    Progress progress(true);
    for (int i = 0; i < 2; ++i) {
        progress.begin("export", "writing");
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        progress.end();
    }
    ASSERT_EQ(progress.times().size(), 1u);
    EXPECT_GE(progress.seconds("export"), 0.020);
}

TEST(Progress, GivesNoTimeForAStageThatWasNotBegun)
{
    EXPECT_EQ(Progress(true).seconds("deploy"), 0.0);
}

}  // namespace
}  // namespace braidzone
