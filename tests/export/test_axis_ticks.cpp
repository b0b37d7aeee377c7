#include "export/axis_ticks.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace braidzone {
namespace {

std::vector<std::string> labels(double lower, double upper, int most_ticks)
{
    std::vector<std::string> result;
    for (const Tick& tick : axis_ticks(lower, upper, most_ticks))
        result.push_back(tick.label);
    return result;
}

TEST(AxisTicks, AreRoundNumbersWithinTheRange)
{
    using Labels = std::vector<std::string>;
    EXPECT_EQ(labels(0.0, 20.0, 5), (Labels{"0", "5", "10", "15", "20"}));
    EXPECT_EQ(labels(0.0, 12.566, 6), (Labels{"0", "5", "10"}));
    EXPECT_EQ(labels(1.97, 2.31, 8),
              (Labels{"2.00", "2.05", "2.10", "2.15", "2.20", "2.25", "2.30"}));
    EXPECT_EQ(labels(-18.0, 9.0, 4), (Labels{"-10", "0"}));
    EXPECT_EQ(labels(0.0, 0.3, 4), (Labels{"0.0", "0.1", "0.2", "0.3"}));
    EXPECT_EQ(labels(0.0, 3000.0, 4), (Labels{"0", "1000", "2000", "3000"}));
}

TEST(AxisTicks, AreNoMoreThanAskedFor)
{
    for (double upper = 0.013; upper < 1e4; upper *= 1.37) {
        const auto ticks = axis_ticks(-0.3 * upper, upper, 6);
        EXPECT_LE(ticks.size(), 6U) << upper;
        EXPECT_GE(ticks.size(), 2U) << upper;
        for (const Tick& tick : ticks) {
            EXPECT_GE(tick.value, -0.3 * upper);
            EXPECT_LE(tick.value, upper);
        }
    }
}

}  // namespace
}  // namespace braidzone
