#include "export/braid_inset.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace braidzone {
namespace {

class BraidInset : public testing::Test {
protected:
    BraidInset() { device.nominal_length = 4e-3; }

    static double distance_to_axis(const Vec3& point) { return std::hypot(point.x(), point.y()); }

    FlowDiverter device = test::pipeline_4x20();
    Vessel vessel = test::tube_vessel(2e-3, 10e-3, 192);
    WallTree wall{vessel};
};

// The wall is a prism: 2 mm at its edges, 2 mm cos(pi / 192) = 1.99973 mm at its faces.
TEST_F(BraidInset, ABraidOnTheWallKeepsTheDistance)
{
    const Deployment on_wall = test::braid_on_cylinder(device, 2e-3, 0.1e-3, 8e-3);
    const InsetBraid braid = inset_braid(on_wall, wall, 60e-6);
    EXPECT_NEAR(braid.largest_inset, 60e-6, 2e-6);
    for (const Vec3& node : braid.nodes) {
        EXPECT_GE(wall.nearest(node).distance, 0.99 * 60e-6);
        EXPECT_NEAR(distance_to_axis(node), 1.94e-3, 2e-6);
    }
}

TEST_F(BraidInset, ABraidFreeOfTheWallStaysWhereItIs)
{
    const Deployment free = test::braid_on_cylinder(device, 1.8e-3, 0.1e-3, 8e-3);
    const InsetBraid braid = inset_braid(free, wall, 60e-6);
    EXPECT_EQ(braid.nodes, free.nodes);
    EXPECT_EQ(braid.largest_inset, 0.0);
}

// Outside by 10 um: moved by that and the distance.
TEST_F(BraidInset, ABraidBeyondTheWallComesBack)
{
    const Deployment beyond = test::braid_on_cylinder(device, 2.01e-3, 0.1e-3, 8e-3);
    for (const Vec3& node : inset_braid(beyond, wall, 60e-6).nodes)
        EXPECT_NEAR(distance_to_axis(node), 1.94e-3, 2e-6);
}

// One node lies on the wall, the others are 200 um from it: its neighbours come with it by a
// quarter of its inset or more, those four rings away do not move.
TEST_F(BraidInset, NeighboursOfANodeOnTheWallMakeATransition)
{
    Deployment braid = test::braid_on_cylinder(device, 1.8e-3, 0.1e-3, 8e-3);
    const BraidLattice& lattice = braid.lattice;
    const auto node = static_cast<std::size_t>(lattice.node(15, 5));
    braid.nodes[node] *= 2.0 / 1.8;
    braid.nodes[node].z() *= 1.8 / 2.0;
    const InsetBraid inset = inset_braid(braid, wall, 60e-6);
    const auto moved = [&](std::size_t i) { return (inset.nodes[i] - braid.nodes[i]).norm(); };
    EXPECT_GE(moved(node), 59e-6);
    EXPECT_GE(moved(static_cast<std::size_t>(lattice.node(16, 5))), 0.25 * moved(node));
    EXPECT_EQ(moved(static_cast<std::size_t>(lattice.node(27, 5))), 0.0);
}

}  // namespace
}  // namespace braidzone
