#include "deploy/press_reading.hpp"

#include <gtest/gtest.h>

namespace braidzone {

// 2 mm into a device of 4 mm with k = 0.6: 10 mN (1 + 0.6 * 0.5) = 13 mN, by hand.
TEST(AsRead, ShiftsTheDisplacementAndStiffensWithIt)
{
    const ForcePoint shown = as_read({2e-3, 10e-3}, {0.1e-3, 0.6}, 4e-3);
    EXPECT_DOUBLE_EQ(shown.displacement, 2.1e-3);
    EXPECT_DOUBLE_EQ(shown.force, 13e-3);
}

TEST(AsRead, IsTheStateItselfByDefault)
{
    const ForcePoint shown = as_read({1e-3, 5e-3}, {}, 4e-3);
    EXPECT_DOUBLE_EQ(shown.displacement, 1e-3);
    EXPECT_DOUBLE_EQ(shown.force, 5e-3);
}

}  // namespace braidzone
