#include "core/error.hpp"
#include "export/lattice_cost.hpp"
#include "export/lattice_nodes.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

using ::testing::HasSubstr;

// As many nodes as the lattice then has; 21 bytes a node for NumPy, 17 for LBPM.
TEST(LatticeCost, CountsWhatIsWritten)
{
    const Vessel vessel = test::tube_vessel(1.5e-3, 6e-3);
    const LatticeCost cost =
        lattice_cost(vessel, 0.1e-3, {LatticeTarget::numpy, LatticeTarget::lbpm});
    PorousField empty;
    empty.grid = {Vec3::Zero(), 0.1e-3, {1, 1, 1}};
    const LatticeNodes nodes = make_lattice_nodes(empty, vessel, 0);
    for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(cost.dims[axis], nodes.grid.dims[axis]);
    EXPECT_DOUBLE_EQ(cost.disk, 38.0 * static_cast<double>(nodes.type.size()));
    EXPECT_GT(cost.memory, cost.num_nodes());
    EXPECT_THAT(describe(cost), HasSubstr(" nodes, "));
}

TEST(RequireRoom, RefusesWithFigures)
{
    LatticeCost cost;
    cost.dims = {1000.0, 1000.0, 500.0};
    cost.spacing = 0.02e-3;
    cost.memory = 4e9;
    cost.disk = 12e9;
    EXPECT_NO_THROW(require_room(cost, {5e9, 13e9}));
    try {
        require_room(cost, {1e9, 13e9});
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("grid.spacing = 0.02 mm gives a lattice of 1000 x 1000 x 500 = 5e+08 "
                              "nodes, 4 GB of memory, 12 GB of disk; the machine has 1 GB"));
        EXPECT_THAT(error.what(), HasSubstr("a spacing of 0.04 mm fits"));
    }
    cost.dims[0] = 8000.0;  // eight times as many nodes as are allowed: twice the spacing
    try {
        require_room(cost, {5e9, 13e9});
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), HasSubstr("at most 5e+08 nodes are allowed, as with a spacing of "
                                            "0.04 mm"));
    }
    cost.dims[0] = 1000.0;
    try {
        require_room(cost, {5e9, 2e9});
        FAIL() << "nothing was thrown";
    } catch (const IoError& error) {
        EXPECT_THAT(error.what(), HasSubstr("12 GB of disk; 2 GB are free there"));
    }
}

TEST(RoomAt, FindsTheMachinesRoom)
{
    const test::TemporaryFolder folder;
    const LatticeRoom room = room_at(folder.path());
    EXPECT_GT(room.memory, 1e8);
    EXPECT_GT(room.disk, 0.0);
    EXPECT_THROW(room_at(folder.path() / "absent"), IoError);
}

}  // namespace
}  // namespace braidzone
