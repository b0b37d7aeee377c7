#include "core/error.hpp"
#include "core/phantom.hpp"
#include "deploy/crimped_braid.hpp"
#include "deploy/neck.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace braidzone {
namespace {

constexpr double tube_radius = 1.9e-3;
constexpr double vessel_length = 30e-3;
constexpr double sac_place = 15e-3;
constexpr double sac_diameter = 5e-3;
constexpr double blend_radius = 0.2e-3;

/// A straight vessel without anything.
Phantom straight_vessel()
{
    Phantom phantom;
    phantom.segments = {{vessel_length, 0.0, 0.0}};
    phantom.proximal_radius = phantom.distal_radius = tube_radius;
    phantom.blend_radius = blend_radius;
    return phantom;
}

/// The same with a spherical sac in its middle, towards the frame's normal.
Phantom vessel_with_sac(double neck)
{
    Phantom phantom = straight_vessel();
    PhantomSac sac;
    sac.position = sac_place;
    sac.diameter = sac.height = sac_diameter;
    sac.neck = neck;
    phantom.sacs = {sac};
    return phantom;
}

/// A vessel and a device that lies in it by hand: circles of one radius about the centerline.
struct LyingDevice {
    WallTree wall;
    Deployment deployment;
};

LyingDevice lying_device(const TriangleMesh& wall, const Centerline& centerline, double distal,
                         double length, double radius = tube_radius)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = length;
    LyingDevice lying{WallTree(make_vessel(wall, LengthUnit{"mm", 1e-3})), {}};
    Deployment& deployment = lying.deployment;
    deployment.lattice = make_lattice(device);
    for (int ring = 0; ring < deployment.lattice.num_rings; ++ring) {
        deployment.ring_arc_length.push_back(distal - ring * deployment.lattice.ring_spacing);
        deployment.rings.push_back(section_at(centerline, deployment.ring_arc_length.back()));
    }
    const CrimpedBraid braid = crimp(deployment.lattice, deployment.rings, radius);
    for (int node = 0; node < deployment.lattice.num_nodes(); ++node)
        deployment.nodes.push_back(on_ray(braid, node, radius));
    return lying;
}

LyingDevice lying_device(const Phantom& phantom, double distal, double length)
{
    const PhantomVessel vessel = make_phantom(phantom);
    return lying_device(vessel.wall, resample(vessel.centerline), distal, length);
}

/// Area of a cylinder of the tube's radius within the sac's sphere, whose section along the tube is
/// the neck. With c the sphere's distance from the axis, c = R + sqrt(r^2 - neck^2 / 4),
///
///     A = int 2 sqrt(r^2 - c^2 - R^2 + 2 R c cos phi) R dphi
double area_over_sphere(double neck)
{
    const double r = 0.5 * sac_diameter;
    const double c = tube_radius + std::sqrt(r * r - 0.25 * neck * neck);
    constexpr int steps = 20000;
    double area = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double phi = std::numbers::pi * ((i + 0.5) / steps - 0.5);
        const double half_width_squared =
            r * r - c * c - tube_radius * tube_radius + 2.0 * tube_radius * c * std::cos(phi);
        if (half_width_squared > 0.0)
            area += 2.0 * std::sqrt(half_width_squared) * tube_radius * std::numbers::pi / steps;
    }
    return area;
}

double place(const Deployment& deployment, int ring)
{
    return deployment.ring_arc_length[static_cast<std::size_t>(ring)];
}

}  // namespace

// The fillet widens the neck by less than twice the blend radius. A ring has a node in the sac's
// direction or half a node spacing off: the end of the neck is found within two ring spacings.
TEST(FindOpenings, FindsTheNeckOfASacWithItsWidthAndArea)
{
    for (const double neck : {3e-3, 4e-3}) {
        Phantom phantom = vessel_with_sac(neck);
        phantom.edge_length = 0.25e-3;
        const LyingDevice lying = lying_device(phantom, 24e-3, 18e-3);
        const Deployment& deployment = lying.deployment;
        const std::vector<WallOpening> openings = find_openings(deployment, lying.wall);
        ASSERT_EQ(openings.size(), 1U) << neck;
        const double distal = place(deployment, openings[0].distal_ring);
        const double proximal = place(deployment, openings[0].proximal_ring);
        const double spacing = deployment.lattice.ring_spacing;
        EXPECT_GT(distal - proximal, neck - 4.0 * spacing);
        EXPECT_LT(distal - proximal, neck + 2.0 * blend_radius);
        EXPECT_NEAR(0.5 * (distal + proximal), sac_place, 2.0 * spacing);
        EXPECT_GT(openings[0].area, 0.97 * area_over_sphere(neck));
        EXPECT_LT(openings[0].area, 1.03 * area_over_sphere(neck + 2.0 * blend_radius));
    }
}

TEST(FindOpenings, GivesTheNodesThatLookIntoTheSacInOrder)
{
    const LyingDevice lying = lying_device(vessel_with_sac(4e-3), 24e-3, 18e-3);
    const std::vector<WallOpening> openings = find_openings(lying.deployment, lying.wall);
    ASSERT_EQ(openings.size(), 1U);
    const std::vector<int>& nodes = openings[0].nodes;
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
    EXPECT_EQ(nodes.front() / lying.deployment.lattice.nodes_per_ring, openings[0].distal_ring);
    EXPECT_EQ(nodes.back() / lying.deployment.lattice.nodes_per_ring, openings[0].proximal_ring);
    for (const int node : nodes) {
        const auto ring = static_cast<std::size_t>(node / lying.deployment.lattice.nodes_per_ring);
        const CrossSection& plane = lying.deployment.rings[ring];
        const Vec3 from_hub = lying.deployment.nodes[static_cast<std::size_t>(node)] - plane.origin;
        EXPECT_GT(from_hub.dot(plane.normal), 0.0) << "node " << node << " is opposite to the sac";
    }
}

TEST(FindOpenings, FindsNoneInAPlainTube)
{
    const LyingDevice lying =
        lying_device(test::tube(tube_radius, vessel_length, 96, 60),
                     test::tube_centerline(tube_radius, vessel_length), 24e-3, 18e-3);
    EXPECT_TRUE(find_openings(lying.deployment, lying.wall).empty());
}

// From 2.6 to 1.4 mm over 30 mm, and 90 degrees on radii of 3.4 and 1.6 times the tube's.
TEST(FindOpenings, TakesNeitherATaperNorABendForANeck)
{
    Phantom taper = straight_vessel();
    taper.proximal_radius = 2.6e-3;
    taper.distal_radius = 1.4e-3;
    const LyingDevice in_taper = lying_device(taper, 26e-3, 20e-3);
    EXPECT_TRUE(find_openings(in_taper.deployment, in_taper.wall).empty());

    for (const double bend_radius : {6.4e-3, 1.6 * tube_radius}) {
        Phantom bend = straight_vessel();
        const double angle = 0.5 * std::numbers::pi;
        bend.segments = {{8e-3, 0.0, 0.0}, {angle * bend_radius, angle, 0.0}, {8e-3, 0.0, 0.0}};
        const LyingDevice in_bend = lying_device(bend, 14e-3 + angle * bend_radius, 16e-3);
        EXPECT_TRUE(find_openings(in_bend.deployment, in_bend.wall).empty()) << bend_radius;
    }
}

// The limits that `NeckOptions::opening_ratio` names.
TEST(FindOpenings, TakesNeitherAnOvalLumenNorACentrelineOffTheMiddleForANeck)
{
    TriangleMesh oval = test::tube(tube_radius, vessel_length, 96, 60);
    for (Vec3& point : oval.points)
        point.x() *= 1.4;
    const Centerline axis = test::tube_centerline(tube_radius, vessel_length);
    const LyingDevice in_oval = lying_device(oval, axis, 24e-3, 18e-3);
    EXPECT_TRUE(find_openings(in_oval.deployment, in_oval.wall).empty());

    TriangleMesh shifted = test::tube(tube_radius, vessel_length, 96, 60);
    for (Vec3& point : shifted.points)
        point.x() += 0.2 * tube_radius;
    const LyingDevice off_middle = lying_device(shifted, axis, 24e-3, 18e-3, 0.7 * tube_radius);
    EXPECT_TRUE(find_openings(off_middle.deployment, off_middle.wall).empty());
}

// Along the vessel the ostium of a branch at right angles is as wide as the branch, r = 0.7 mm.
// Around it, a ray from the hub at the angle phi is still in the branch at 1.2 R if
// 1.2 R sin phi < r. The window's area is about that of the ellipse, pi r R phi, and less than
// pi (r + blend radius)^2; it is smaller than the neck's.
TEST(FindOpenings, FindsTheOstiumOfABranchAfterTheLargerNeck)
{
    Phantom phantom = vessel_with_sac(4e-3);
    PhantomBranch branch;
    branch.position = 9e-3;
    branch.direction = std::numbers::pi;
    branch.tilt = 0.5 * std::numbers::pi;
    branch.radius = 0.7e-3;
    branch.length = 6e-3;
    phantom.branches = {branch};
    const LyingDevice lying = lying_device(phantom, 24e-3, 19e-3);
    const std::vector<WallOpening> openings = find_openings(lying.deployment, lying.wall);
    ASSERT_EQ(openings.size(), 2U);
    EXPECT_GT(openings[0].area, openings[1].area);
    const auto middle = [&](const WallOpening& opening) {
        return 0.5 * (place(lying.deployment, opening.distal_ring) +
                      place(lying.deployment, opening.proximal_ring));
    };
    EXPECT_NEAR(middle(openings[0]), sac_place, 0.3e-3);
    EXPECT_NEAR(middle(openings[1]), branch.position, 0.3e-3);
    const double wide = branch.radius + blend_radius;
    const double phi = std::asin(branch.radius / (1.2 * tube_radius));
    EXPECT_GT(openings[1].area, 0.95 * std::numbers::pi * branch.radius * tube_radius * phi);
    EXPECT_LT(openings[1].area, std::numbers::pi * wide * wide);
}

// A device that ends 1 mm before the middle of a 4 mm neck, and one of 3 mm within that neck.
TEST(FindOpenings, NeedsTheTubeOnOneSideOnly)
{
    const Phantom phantom = vessel_with_sac(4e-3);
    const LyingDevice ends_there = lying_device(phantom, sac_place - 1e-3, 10e-3);
    const std::vector<WallOpening> at_end = find_openings(ends_there.deployment, ends_there.wall);
    ASSERT_EQ(at_end.size(), 1U);
    EXPECT_EQ(at_end[0].distal_ring, 0);
    EXPECT_NEAR(place(ends_there.deployment, at_end[0].proximal_ring), sac_place - 2e-3,
                2.0 * blend_radius);

    const LyingDevice within = lying_device(phantom, sac_place + 1.5e-3, 3e-3);
    const std::vector<WallOpening> whole = find_openings(within.deployment, within.wall);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].distal_ring, 0);
    EXPECT_EQ(whole[0].proximal_ring, within.deployment.lattice.num_rings - 1);
}

// A widening from 1.9 to 3.8 mm over 4 mm of the vessel, cosine-shaped.
TEST(FindOpenings, FindsAWideningAllRoundOnlyWhereItIsGiven)
{
    TriangleMesh fusiform = test::tube(tube_radius, vessel_length, 96, 120);
    for (Vec3& point : fusiform.points) {
        const double off = (point.z() - sac_place) / 2e-3;
        if (!(std::abs(off) < 1.0)) continue;
        const double scale = 1.0 + 0.5 * (1.0 + std::cos(std::numbers::pi * off));
        point.x() *= scale;
        point.y() *= scale;
    }
    const LyingDevice lying =
        lying_device(fusiform, test::tube_centerline(tube_radius, vessel_length), 24e-3, 18e-3);
    EXPECT_TRUE(find_openings(lying.deployment, lying.wall).empty());

    NeckOptions options;
    options.given = ArcRange{12.5e-3, 17.5e-3};
    const std::vector<WallOpening> openings = find_openings(lying.deployment, lying.wall, options);
    ASSERT_EQ(openings.size(), 1U);
    // scale > 1.2 where cos(pi off) > -0.6: |off| < 0.705, 1.41 mm to each side.
    int rings = 0;
    for (const double arc_length : lying.deployment.ring_arc_length)
        rings += std::abs(arc_length - sac_place) < 1.41e-3 ? 1 : 0;
    const int num_nodes = static_cast<int>(openings[0].nodes.size());
    EXPECT_NEAR(num_nodes, 24 * rings, 2 * 24);
}

TEST(FindOpenings, TakesTheGivenStretchForTheNeck)
{
    const LyingDevice lying = lying_device(vessel_with_sac(4e-3), 24e-3, 18e-3);
    const std::vector<WallOpening> found = find_openings(lying.deployment, lying.wall);
    NeckOptions options;
    options.given = ArcRange{11e-3, 19e-3};
    const std::vector<WallOpening> given = find_openings(lying.deployment, lying.wall, options);
    ASSERT_EQ(found.size(), 1U);
    ASSERT_EQ(given.size(), 1U);
    EXPECT_EQ(given[0].nodes, found[0].nodes);
    EXPECT_DOUBLE_EQ(given[0].area, found[0].area);
    // The first ring below 19 mm, the last one above 11 mm.
    const double spacing = lying.deployment.lattice.ring_spacing;
    EXPECT_LE(place(lying.deployment, given[0].distal_ring), 19e-3);
    EXPECT_GT(place(lying.deployment, given[0].distal_ring), 19e-3 - spacing);
    EXPECT_GE(place(lying.deployment, given[0].proximal_ring), 11e-3);
    EXPECT_LT(place(lying.deployment, given[0].proximal_ring), 11e-3 + spacing);
}

TEST(FindOpenings, KeepsAGivenNeckBehindWhichNothingOpens)
{
    const LyingDevice lying = lying_device(vessel_with_sac(4e-3), 24e-3, 18e-3);
    NeckOptions options;
    options.given = ArcRange{8e-3, 10e-3};
    const std::vector<WallOpening> openings = find_openings(lying.deployment, lying.wall, options);
    ASSERT_EQ(openings.size(), 2U);
    EXPECT_TRUE(openings[0].nodes.empty());
    EXPECT_EQ(openings[0].area, 0.0);
    EXPECT_NEAR(place(lying.deployment, openings[1].distal_ring), 17e-3, 0.4e-3);
}

TEST(FindOpenings, RefusesAStretchThatTheDeviceDoesNotReach)
{
    const LyingDevice lying =
        lying_device(test::tube(tube_radius, vessel_length, 96, 60),
                     test::tube_centerline(tube_radius, vessel_length), 24e-3, 18e-3);
    NeckOptions options;
    options.given = ArcRange{25e-3, 28e-3};
    try {
        find_openings(lying.deployment, lying.wall, options);
        FAIL() << "nothing was thrown";
    } catch (const GeometryError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("deployment.neck = 25 to 28 mm along the centerline holds no ring of "
                            "the device, which lies from "),
                  std::string::npos)
            << what;
        EXPECT_NE(what.find(" to 24 mm"), std::string::npos) << what;
    }
}

// With a node count above that of any opening, all are unevenness of the wall.
TEST(FindOpenings, LeavesOutSmallPatches)
{
    const LyingDevice lying = lying_device(vessel_with_sac(3e-3), 24e-3, 18e-3);
    NeckOptions options;
    options.fewest_nodes = lying.deployment.lattice.num_nodes();
    EXPECT_TRUE(find_openings(lying.deployment, lying.wall, options).empty());
}

TEST(NodesOf, FlagsTheNodesOfAllOpenings)
{
    const std::vector<WallOpening> openings = {{{1, 3}, 0, 0, 0.0}, {{4}, 0, 0, 0.0}};
    EXPECT_EQ(nodes_of(openings, 6), (std::vector<char>{0, 1, 0, 1, 1, 0}));
    EXPECT_EQ(nodes_of({}, 2), (std::vector<char>{0, 0}));
}

}  // namespace braidzone
