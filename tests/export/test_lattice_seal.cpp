#include "export/lattice_seal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace braidzone {
namespace {

/// A channel of 3 x 3 nodes along x, inlet at 0, with a wall of resisting nodes at x = 4.
LatticeNodes parted_channel()
{
    LatticeNodes nodes;
    nodes.grid.spacing = 1e-3;
    nodes.grid.dims = {9, 5, 5};
    nodes.type.assign(nodes.grid.num_voxels(), 1);
    for (int k = 1; k < 4; ++k) {
        for (int j = 1; j < 4; ++j) {
            for (int i = 0; i < 9; ++i) {
                const std::size_t node = nodes.grid.index(i, j, k);
                nodes.type[node] = i == 0 ? 10 : 2;
                if (i == 4) nodes.resisting.push_back(static_cast<std::int64_t>(node));
            }
        }
    }
    return nodes;
}

const NeckProbe along{Vec3(4e-3, 2e-3, 2e-3), Vec3::UnitX()};

TEST(LatticeSeal, FindsWhatLiesBehindTheDevice)
{
    const LatticeSeal seal = lattice_seal(parted_channel(), {along});
    EXPECT_THAT(seal.necks, ::testing::ElementsAre(NeckSeal::sealed));
    EXPECT_EQ(seal.num_behind, 4 * 9);
}

// One node without resistance is enough; a diagonal step is no way through.
TEST(LatticeSeal, FindsALeak)
{
    LatticeNodes nodes = parted_channel();
    const std::int64_t hole = nodes.resisting.back();
    nodes.resisting.pop_back();
    const LatticeSeal leaking = lattice_seal(nodes, {along});
    EXPECT_THAT(leaking.necks, ::testing::ElementsAre(NeckSeal::leaks));
    EXPECT_EQ(leaking.num_behind, 0);
    nodes.resisting.push_back(hole + 1);  // behind the hole: only diagonal steps lead on
    const LatticeSeal closed = lattice_seal(nodes, {along});
    EXPECT_THAT(closed.necks, ::testing::ElementsAre(NeckSeal::sealed));
}

// Outwards along y the wall comes at once; without a device the probe is on the near side.
TEST(LatticeSeal, SaysIfNothingIsBehind)
{
    EXPECT_THAT(lattice_seal(parted_channel(), {{along.centre, Vec3::UnitY()}}).necks,
                ::testing::ElementsAre(NeckSeal::absent));
    LatticeNodes bare = parted_channel();
    bare.resisting.clear();
    const LatticeSeal seal = lattice_seal(bare, {along});
    EXPECT_THAT(seal.necks, ::testing::ElementsAre(NeckSeal::leaks));
    EXPECT_EQ(seal.num_behind, 0);
}

TEST(NeckProbes, LieOnTheDeviceAndPointAway)
{
    Deployment deployment;
    deployment.lattice.nodes_per_ring = 4;
    deployment.nodes = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0),
                        Vec3(1, 0, 1), Vec3(0, 1, 1), Vec3(-1, 0, 1), Vec3(0, -1, 1)};
    deployment.rings.resize(2);
    deployment.rings[1].origin = Vec3(0, 0, 1);
    WallOpening neck, none;
    neck.nodes = {0, 5, 7};  // mean (1/3, 0, 2/3); the nearest is (1, 0, 0)
    const std::vector<NeckProbe> probes = neck_probes(deployment, {neck, none});
    ASSERT_EQ(probes.size(), 1U);
    EXPECT_EQ(probes[0].centre, Vec3(1, 0, 0));
    EXPECT_EQ(probes[0].outwards, Vec3(1, 0, 0));
}

}  // namespace
}  // namespace braidzone
