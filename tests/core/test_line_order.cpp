#include "core/error.hpp"
#include "core/line_order.hpp"
#include "support/bent_tubes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace braidzone {
namespace {

Polyline straight(int num_points)
{
    Polyline line;
    for (int i = 0; i < num_points; ++i) {
        line.points.emplace_back(0.0, 0.0, 1e-3 * i);
        line.inscribed_radii.push_back(1e-3 + 1e-6 * i);
    }
    return line;
}

Polyline helix(int num_points)
{
    Polyline line;
    for (int i = 0; i < num_points; ++i) {
        const double turn = 0.2 * i;
        line.points.emplace_back(4e-3 * std::cos(turn), 4e-3 * std::sin(turn), 1e-3 * turn);
    }
    return line;
}

TEST(InEvidentOrder, PutsAFirstPointThatIsStoredLastToTheFront)
{
    const Polyline line = straight(30);
    Polyline stored = line;
    std::rotate(stored.points.begin(), stored.points.begin() + 1, stored.points.end());
    std::rotate(stored.inscribed_radii.begin(), stored.inscribed_radii.begin() + 1,
                stored.inscribed_radii.end());
    const OrderedLine ordered = in_evident_order(stored);
    EXPECT_EQ(ordered.line.points, line.points);
    EXPECT_EQ(ordered.line.inscribed_radii, line.inscribed_radii);
    EXPECT_EQ(ordered.num_misplaced, 1);
}

TEST(InEvidentOrder, OrdersExchangedNeighboursAndShuffledPoints)
{
    const Polyline line = helix(60);
    Polyline exchanged = line;
    std::swap(exchanged.points[20], exchanged.points[21]);
    EXPECT_EQ(in_evident_order(exchanged).line.points, line.points);

    Polyline shuffled = line;
    std::shuffle(shuffled.points.begin(), shuffled.points.end(), std::mt19937(7));
    std::vector<Vec3> found = in_evident_order(shuffled).line.points;
    if (found.front() != line.points.front()) std::reverse(found.begin(), found.end());
    EXPECT_EQ(found, line.points);
}

// The direction is the file's: its first point is the proximal end.
TEST(InEvidentOrder, KeepsTheDirectionOfMostSegments)
{
    Polyline line = straight(20);
    std::reverse(line.points.begin(), line.points.end());
    Polyline stored = line;
    std::rotate(stored.points.begin(), stored.points.begin() + 1, stored.points.end());
    EXPECT_EQ(in_evident_order(stored).line.points, line.points);
}

TEST(InEvidentOrder, LeavesLinesThatAreInOrder)
{
    Polyline uneven = helix(60);
    uneven.points.erase(uneven.points.begin() + 20, uneven.points.begin() + 29);
    Polyline repeated = straight(10);
    repeated.points.insert(repeated.points.begin() + 4, repeated.points[4]);
    repeated.inscribed_radii.push_back(1e-3);
    // Limbs of a U that are nearer to each other, 4.1 mm, than the points of a limb, 6 mm.
    const test::UTube kissing{2e-3, 2.05e-3, 20e-3};
    Polyline sparse;
    for (double s = 0.0; s < kissing.length(); s += 6e-3)
        sparse.points.push_back(kissing.axis(s));
    for (const Polyline& line : {uneven, repeated, sparse, straight(2), straight(3)}) {
        const OrderedLine ordered = in_evident_order(line);
        EXPECT_EQ(ordered.line.points, line.points);
        EXPECT_EQ(ordered.num_misplaced, 0);
    }
}

// Two strands that start at one place and are written one after the other are no line.
TEST(InEvidentOrder, RefusesAJumpThatNoOtherOrderAvoids)
{
    Polyline fork;
    for (int i = 0; i <= 20; ++i)
        fork.points.emplace_back(0.0, 0.0, 1e-3 * i);
    for (int i = 1; i <= 8; ++i)
        fork.points.emplace_back(1e-3 * i, 0.0, 10e-3);
    try {
        in_evident_order(fork);
        FAIL() << "accepted";
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find("jumps from (0, 0, 20) mm to (1, 0, 10) mm"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace braidzone
