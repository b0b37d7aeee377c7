#include "core/line_network.hpp"
#include "core/line_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace braidzone {
namespace {

Polyline line_of(std::vector<Vec3> points)
{
    return {std::move(points), {}};
}

// A trunk along z with a branch from its end and one from a point within it, as the cells of a
// merged file are, and a line elsewhere.
class TestLineNetwork : public testing::Test {
protected:
    int end_at(const Vec3& place) const
    {
        for (const int end : network.free_ends()) {
            if ((network.place(end) - place).norm() < 1e-9) return end;
        }
        return -1;
    }

    const Vec3 inlet{0, 0, 0}, middle{0, 0, 10e-3}, fork{0, 0, 20e-3};
    const Vec3 left{-5e-3, 0, 24e-3}, right{5e-3, 0, 24e-3}, side{8e-3, 0, 10e-3};
    const Polyline away = line_of({Vec3(50e-3, 0, 0), Vec3(50e-3, 0, 9e-3)});
    // The common points differ by rounding to single precision.
    const LineNetwork network{{line_of({inlet, middle, fork}), line_of({left, fork}),
                               line_of({fork * (1.0 + 6e-8), right}),
                               line_of({middle * (1.0 - 6e-8), side}), away}};
};

TEST_F(TestLineNetwork, EndsWhereOneLineEnds)
{
    EXPECT_EQ(network.free_ends().size(), 6u);
    for (const Vec3& end : {inlet, left, right, side}) {
        EXPECT_GE(end_at(end), 0);
        EXPECT_TRUE(network.ends_at(end));
    }
    EXPECT_FALSE(network.ends_at(fork));
    EXPECT_FALSE(network.ends_at(middle));
}

TEST_F(TestLineNetwork, FindsThePathOverSeveralLines)
{
    EXPECT_EQ(network.path(end_at(inlet), end_at(left)).points,
              (std::vector<Vec3>{inlet, middle, fork, left}));
    EXPECT_EQ(network.path(end_at(side), end_at(right)).points.size(), 4u);
    EXPECT_TRUE(network.path(end_at(inlet), end_at(away.points.front())).points.empty());
}

TEST(LinePoints, LengthAndDirection)
{
    Polyline line = line_of({Vec3(0, 0, 0), Vec3(3e-3, 0, 0), Vec3(3e-3, 4e-3, 0)});
    line.inscribed_radii = {1e-3, 2e-3, 3e-3};
    EXPECT_NEAR(length_of(line), 7e-3, 1e-15);
    const Polyline back = reversed(line);
    EXPECT_EQ(back.points.front(), line.points.back());
    EXPECT_EQ(back.inscribed_radii, (std::vector<double>{3e-3, 2e-3, 1e-3}));
}

}  // namespace
}  // namespace braidzone
