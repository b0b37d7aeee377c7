#include "core/phantom.hpp"
#include "deploy/crimped_braid.hpp"
#include "deploy/opening_kind.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace braidzone {
namespace {

constexpr double tube_radius = 1.9e-3;
constexpr double vessel_length = 30e-3;
constexpr double pi = std::numbers::pi;

Phantom straight_vessel(double edge_length = 0.4e-3)
{
    Phantom phantom;
    phantom.segments = {{vessel_length, 0.0, 0.0}};
    phantom.proximal_radius = phantom.distal_radius = tube_radius;
    phantom.blend_radius = 0.2e-3;
    phantom.edge_length = edge_length;
    return phantom;
}

PhantomSac sac_at(double place, double direction = 0.0)
{
    PhantomSac sac;
    sac.position = place;
    sac.direction = direction;
    sac.diameter = sac.height = 5e-3;
    sac.neck = 3.5e-3;
    return sac;
}

PhantomBranch branch_at(double place, double radius, double length)
{
    PhantomBranch branch;
    branch.position = place;
    branch.direction = pi;
    branch.tilt = 0.5 * pi;
    branch.radius = radius;
    branch.length = length;
    return branch;
}

/// A device that is laid along a line by hand, in circles of the tube's radius.
Deployment lying(const Centerline& line, double distal, double length)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = length;
    Deployment deployment;
    deployment.lattice = make_lattice(device);
    for (int ring = 0; ring < deployment.lattice.num_rings; ++ring) {
        deployment.ring_arc_length.push_back(distal - ring * deployment.lattice.ring_spacing);
        deployment.rings.push_back(section_at(line, deployment.ring_arc_length.back()));
    }
    const CrimpedBraid braid = crimp(deployment.lattice, deployment.rings, tube_radius);
    for (int node = 0; node < deployment.lattice.num_nodes(); ++node)
        deployment.nodes.push_back(on_ray(braid, node, tube_radius));
    return deployment;
}

/// What lies behind such a device.
std::vector<WallOpening> kinds(const TriangleMesh& wall, const Centerline& line, double distal,
                               double length)
{
    const Vessel vessel = make_vessel(wall, LengthUnit{"mm", 1e-3});
    const WallTree tree(vessel);
    const Deployment deployment = lying(line, distal, length);
    return told_apart(find_openings(deployment, tree), deployment, {vessel, tree, line});
}

std::vector<WallOpening> kinds(const Phantom& phantom, double distal, double length)
{
    const PhantomVessel vessel = make_phantom(phantom);
    return kinds(vessel.wall, resample(vessel.centerline), distal, length);
}

std::vector<OpeningKind> kinds_of(const std::vector<WallOpening>& openings)
{
    std::vector<OpeningKind> kinds;
    for (const WallOpening& opening : openings)
        kinds.push_back(opening.kind);
    return kinds;
}

using Kinds = std::vector<OpeningKind>;
constexpr OpeningKind sac = OpeningKind::sac, branch = OpeningKind::branch, end = OpeningKind::end;

/// A tube whose radius is scaled along it.
template <typename Scale>
TriangleMesh scaled_tube(Scale scale)
{
    TriangleMesh mesh = test::tube(tube_radius, vessel_length, 96, 120);
    for (Vec3& point : mesh.points) {
        const double factor = scale(point.z());
        point.x() *= factor;
        point.y() *= factor;
    }
    return mesh;
}

}  // namespace

TEST(ToldApart, KnowsASacFromABranchHoweverFineTheWall)
{
    for (const double edge : {0.25e-3, 0.8e-3}) {
        Phantom phantom = straight_vessel(edge);
        phantom.sacs = {sac_at(15e-3)};
        EXPECT_EQ(kinds_of(kinds(phantom, 24e-3, 18e-3)), Kinds{sac}) << edge;
        phantom.sacs.clear();
        phantom.branches = {branch_at(15e-3, 1.0e-3, 6e-3)};
        const std::vector<WallOpening> openings = kinds(phantom, 24e-3, 18e-3);
        ASSERT_EQ(kinds_of(openings), Kinds{branch}) << edge;
        // The smallest of three openings.
        EXPECT_EQ(openings[0].vessel_openings, std::vector<int>{2});
    }
}

// The stump is cut 1 mm beyond the wall: rays leave through it without meeting a wall.
TEST(ToldApart, KnowsABranchThatIsCutShort)
{
    Phantom phantom = straight_vessel(0.3e-3);
    phantom.branches = {branch_at(15e-3, 1.0e-3, tube_radius + 1.5e-3)};
    EXPECT_EQ(kinds_of(kinds(phantom, 24e-3, 18e-3)), Kinds{branch});
}

// A branch rises from the wall beside the neck, so that mouth and ostium run into each other: the
// sac's neck still counts, with its own nodes. The sac's middle lies 4.3 mm from the axis, the
// branch leaves 3 mm further on at 60 degrees, away from the sac.
TEST(ToldApart, KnowsASacWhoseMouthRunsIntoABranch)
{
    Phantom alone = straight_vessel(0.3e-3);
    alone.sacs = {sac_at(13e-3)};
    const std::vector<WallOpening> neck = kinds(alone, 24e-3, 20e-3);
    ASSERT_EQ(kinds_of(neck), Kinds{sac});
    Phantom both = alone;
    both.branches = {branch_at(15e-3, 1.0e-3, 9e-3)};
    both.branches[0].direction = 0.0;
    both.branches[0].tilt = pi / 3.0;
    const std::vector<WallOpening> openings = kinds(both, 24e-3, 20e-3);
    ASSERT_EQ(kinds_of(openings), (Kinds{sac, branch}));
    EXPECT_NEAR(openings[0].area, neck[0].area, 0.25 * neck[0].area);
    EXPECT_EQ(openings[1].vessel_openings, std::vector<int>{2});
}

// The branch's ostium is larger than the sac's mouth, and the sac still comes first.
TEST(ToldApart, PutsSacsBeforeBranches)
{
    Phantom phantom = straight_vessel();
    phantom.sacs = {sac_at(18e-3)};
    phantom.sacs[0].neck = 2e-3;
    phantom.branches = {branch_at(10e-3, 1.6e-3, 7e-3)};
    const std::vector<WallOpening> openings = kinds(phantom, 25e-3, 20e-3);
    ASSERT_EQ(kinds_of(openings), (Kinds{sac, branch}));
    EXPECT_LT(openings[0].area, openings[1].area);
    EXPECT_EQ(neck_of(openings), &openings[0]);
}

TEST(ToldApart, KnowsTwoSacs)
{
    Phantom phantom = straight_vessel();
    phantom.sacs = {sac_at(10e-3), sac_at(19e-3, pi)};
    EXPECT_EQ(kinds_of(kinds(phantom, 26e-3, 22e-3)), (Kinds{sac, sac}));
}

TEST(ToldApart, FindsNothingInAPlainTube)
{
    EXPECT_TRUE(kinds(scaled_tube([](double) { return 1.0; }),
                      test::tube_centerline(tube_radius, vessel_length), 24e-3, 18e-3)
                    .empty());
}

// The device ends in the middle of the neck: the sac is not closed off, flow passes the rim.
TEST(ToldApart, CallsADeviceThatEndsInANeckAPoorEnd)
{
    Phantom phantom = straight_vessel();
    phantom.sacs = {sac_at(15e-3)};
    const std::vector<WallOpening> openings = kinds(phantom, 15e-3, 10e-3);
    ASSERT_EQ(kinds_of(openings), Kinds{end});
    EXPECT_TRUE(openings[0].in_sac);
    EXPECT_EQ(neck_of(openings), nullptr);
}

// From 16 mm on the vessel is 1.5 times as wide; the device ends at 20 mm and stays as it is.
TEST(ToldApart, CallsAnEndThatHangsFreeInAWideVesselAPoorEnd)
{
    const std::vector<WallOpening> openings =
        kinds(scaled_tube([](double z) { return z > 16e-3 ? 1.5 : 1.0; }),
              test::tube_centerline(tube_radius, vessel_length), 20e-3, 14e-3);
    ASSERT_EQ(kinds_of(openings), Kinds{end});
    // 4 mm of a cylinder of 1.9 mm, to a ring spacing at the edge.
    EXPECT_NEAR(openings[0].area, 2.0 * pi * tube_radius * 4e-3, 2.0 * pi * tube_radius * 1e-3);
}

// From 1.9 to 3.8 mm over 5 mm, cosine-shaped; more than 1.2 times as wide within
// cos(pi off) > -0.6, that is 0.705 of the half length to each side.
TEST(ToldApart, CallsAWideningAllRoundBetweenTwoLandingZonesASac)
{
    const auto widening = [](double z) {
        const double off = (z - 15e-3) / 2.5e-3;
        return std::abs(off) < 1.0 ? 1.0 + 0.5 * (1.0 + std::cos(pi * off)) : 1.0;
    };
    const std::vector<WallOpening> openings = kinds(
        scaled_tube(widening), test::tube_centerline(tube_radius, vessel_length), 24e-3, 18e-3);
    ASSERT_EQ(kinds_of(openings), Kinds{sac});
    const double length = 2.0 * 0.705 * 2.5e-3;
    EXPECT_NEAR(openings[0].area, 2.0 * pi * tube_radius * length, 2.0 * pi * tube_radius * 1.2e-3);
}

// Nodes 2 to 6 of a few rings, where a plain tube's wall is behind them.
TEST(ToldApart, DropsAnOpeningBehindWhichThereIsTheParentsWall)
{
    const Vessel vessel = test::tube_vessel(tube_radius, vessel_length);
    const WallTree wall(vessel);
    const Centerline line = test::tube_centerline(tube_radius, vessel_length);
    const Deployment deployment = lying(line, 25e-3, 20e-3);
    WallOpening opening;
    for (int ring = 10; ring < 13; ++ring) {
        for (int column = 2; column < 7; ++column)
            opening.nodes.push_back(deployment.lattice.node(ring, column));
    }
    EXPECT_TRUE(told_apart({opening}, deployment, {vessel, wall, line}).empty());
}

TEST(ToldApart, KeepsAGivenNeckFirst)
{
    WallOpening given;
    given.distal_ring = 3;
    given.proximal_ring = 8;
    const Vessel vessel = test::tube_vessel(tube_radius, vessel_length);
    const WallTree wall(vessel);
    const Centerline line = test::tube_centerline(tube_radius, vessel_length);
    const Deployment deployment = lying(line, 25e-3, 20e-3);
    const std::vector<WallOpening> openings =
        told_apart({given}, deployment, {vessel, wall, line}, true);
    ASSERT_EQ(openings.size(), 1U);
    EXPECT_EQ(openings[0].distal_ring, 3);
    EXPECT_EQ(neck_of(openings), &openings[0]);
}

}  // namespace braidzone
