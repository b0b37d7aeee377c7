#include "export/wire_gap.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

// Two wires cross at a height of 0.4 above x = 0.3, a third one is 5 away.
TEST(SmallestGap, IsFoundWhereTwoWiresCross)
{
    const std::vector<std::vector<Vec3>> lines{{Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)},
                                               {Vec3(0.3, -1, 0.4), Vec3(0.3, 1, 0.4)},
                                               {Vec3(-1, 0, 5), Vec3(1, 0, 5)}};
    const WireGap gap = smallest_gap(lines, 1.0, 0.5);
    EXPECT_DOUBLE_EQ(gap.distance, 0.4);
    EXPECT_EQ(gap.place, Vec3(0.5, 0, 0));  // the middle of the piece
    // Both pieces of the first wire count: the one to the left is hypot(0.3, 0.4) away.
    EXPECT_EQ(gap.num_closer, 1U);
    EXPECT_EQ(smallest_gap(lines, 1.0, 0.51).num_closer, 2U);
}

TEST(SmallestGap, DoesNotCountPiecesOfOneWire)
{
    const WireGap gap = smallest_gap({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0.1, 0)}}, 1.0, 1.0);
    EXPECT_FALSE(std::isfinite(gap.distance));
    EXPECT_EQ(gap.num_closer, 0U);
}

TEST(SmallestGap, IsInfiniteBeyondItsReach)
{
    const WireGap gap =
        smallest_gap({{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {Vec3(0, 2, 0), Vec3(1, 2, 0)}}, 1.0, 0.5);
    EXPECT_FALSE(std::isfinite(gap.distance));
}

TEST(SmallestGap, IsNoneForWiresThatMeet)
{
    const WireGap gap =
        smallest_gap({{Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {Vec3(0, -1, 0), Vec3(0, 1, 0)}}, 0.5, 0.1);
    EXPECT_EQ(gap.distance, 0.0);
    EXPECT_EQ(gap.num_closer, 1U);
}

}  // namespace
}  // namespace braidzone
