#include "core/error.hpp"
#include "deploy/deployment.hpp"
#include "deploy/incomplete_opening.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace braidzone {

namespace {

constexpr double radius = 1.85e-3;
constexpr double length = 12e-3;

Deployment deploy_in_tube(const std::vector<IncompleteOpening>& openings,
                          const DeployOptions& options = {})
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 8e-3;
    const Vessel vessel = test::tube_vessel(radius, length);
    return deploy(device, test::tube_centerline(radius, length), WallTree(vessel), 10e-3,
                  {.incomplete_openings = openings}, options);
}

double mean_radius(const Deployment& deployment, int ring)
{
    const int n = deployment.lattice.nodes_per_ring;
    double sum = 0.0;
    for (int column = 0; column < n; ++column) {
        sum += (deployment.nodes[static_cast<std::size_t>(ring * n + column)] -
                deployment.rings[static_cast<std::size_t>(ring)].origin)
                   .norm();
    }
    return sum / n;
}

std::string refusal(const std::vector<IncompleteOpening>& openings)
{
    try {
        validate(openings);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

// R0 sqrt(1 + 0.16) = 2.1541 mm is as far as the braid opens; half-way along the cone the share is
// half of that at the end.
TEST(NarrowedStops, FollowTheCone)
{
    BraidLattice lattice;
    lattice.nodes_per_ring = 2;
    lattice.num_rings = 3;
    lattice.nominal_radius = 2e-3;
    const std::vector<double> stops = {1.8e-3, 3e-3, 1.8e-3, 3e-3, 1.8e-3, 3e-3};
    const std::vector<double> narrowed = narrowed_stops(
        {{DeviceEnd::proximal, 4e-3, 0.2}}, stops, lattice, {14e-3, 12e-3, 10e-3}, 0.4, 0.3e-3);
    EXPECT_EQ(narrowed[0], 1.8e-3);
    EXPECT_EQ(narrowed[1], 3e-3);
    EXPECT_NEAR(narrowed[2], 0.9 * 1.8e-3, 1e-12);
    EXPECT_NEAR(narrowed[3], 0.9 * 2.15407e-3, 1e-8);
    EXPECT_NEAR(narrowed[4], 0.8 * 1.8e-3, 1e-12);
    EXPECT_NEAR(narrowed[5], 0.8 * 2.15407e-3, 1e-8);

    const std::vector<double> tight = narrowed_stops({{DeviceEnd::distal, 4e-3, 0.8}}, stops,
                                                     lattice, {14e-3, 12e-3, 10e-3}, 0.4, 0.5e-3);
    EXPECT_EQ(tight[0], 0.5e-3);
    EXPECT_EQ(tight[4], 1.8e-3);
}

// At the very end a cone of 0.2 that leans by a half takes 0.1 off the side it leans to (node 0, at
// 0 degrees), 0.3 off the other.
TEST(NarrowedStops, LeanToOneSide)
{
    BraidLattice lattice;
    lattice.nodes_per_ring = 4;
    lattice.num_rings = 2;
    lattice.nominal_radius = 2e-3;
    const std::vector<double> stops(8, 1.8e-3);
    const std::vector<double> narrowed =
        narrowed_stops({{.end = DeviceEnd::distal, .length = 2e-3, .shrink = 0.2, .lean = 0.5}},
                       stops, lattice, {14e-3, 12e-3}, 0.4, 0.3e-3);
    ASSERT_EQ(lattice.angle(0, 0), 0.0);
    EXPECT_NEAR(narrowed[0], 0.9 * 1.8e-3, 1e-12);
    EXPECT_NEAR(narrowed[1], 0.8 * 1.8e-3, 1e-12);
    EXPECT_NEAR(narrowed[2], 0.7 * 1.8e-3, 1e-12);
    EXPECT_NEAR(narrowed[3], 0.8 * 1.8e-3, 1e-12);
    const std::vector<double> turned = narrowed_stops({{.end = DeviceEnd::distal,
                                                        .length = 2e-3,
                                                        .shrink = 0.2,
                                                        .lean = 1.0,
                                                        .lean_angle = std::numbers::pi / 2}},
                                                      stops, lattice, {14e-3, 12e-3}, 0.4, 0.3e-3);
    EXPECT_NEAR(turned[1], 1.8e-3, 1e-12);
    EXPECT_NEAR(turned[3], 0.6 * 1.8e-3, 1e-12);
}

// Everywhere the wall holds the braid in a tube of 1.85 mm, the cone takes its place: at the end
// 0.8 of the radius, from 3 mm on all of it.
TEST(IncompleteOpening, LeavesAConeAtItsEnd)
{
    for (const DeviceEnd end : {DeviceEnd::proximal, DeviceEnd::distal}) {
        const Deployment open = deploy_in_tube({});
        const Deployment cone = deploy_in_tube({{end, 3e-3, 0.2}});
        ASSERT_TRUE(cone.converged);
        const int last = cone.lattice.num_rings - 1;
        const int tip = end == DeviceEnd::proximal ? last : 0;
        EXPECT_NEAR(mean_radius(cone, tip) / mean_radius(open, tip), 0.8, 1e-6);
        for (int ring = 0; ring <= last; ++ring) {
            const double from_end = std::abs(cone.ring_arc_length[static_cast<std::size_t>(ring)] -
                                             cone.ring_arc_length[static_cast<std::size_t>(tip)]);
            if (from_end <= 3e-3) continue;
            EXPECT_NEAR(mean_radius(cone, ring), mean_radius(open, ring), 1e-9) << ring;
        }
        const int node = cone.lattice.node(tip, 0);
        EXPECT_EQ(cone.in_contact[static_cast<std::size_t>(node)], 0);
        EXPECT_EQ(cone.contact_force[static_cast<std::size_t>(node)], 0.0);
        EXPECT_NEAR(cone.wall_distance[static_cast<std::size_t>(node)], 0.2 * radius, 3e-6);
    }
}

// The cone of a compliant wall is not taken for the wall.
TEST(IncompleteOpening, StandsBesideACompliantWall)
{
    DeployOptions options;
    options.wall_stiffness = 1e7;
    const Deployment cone = deploy_in_tube({{DeviceEnd::proximal, 3e-3, 0.2}}, options);
    ASSERT_TRUE(cone.converged);
    const int last = cone.lattice.num_rings - 1;
    EXPECT_EQ(cone.wall_displacement[static_cast<std::size_t>(cone.lattice.node(last, 0))], 0.0);
    EXPECT_GT(cone.wall_distance[static_cast<std::size_t>(cone.lattice.node(last, 0))], 0.3e-3);
    EXPECT_GT(cone.wall_displacement[static_cast<std::size_t>(cone.lattice.node(20, 0))], 5e-6);
}

TEST(IncompleteOpening, RefusesWhatIsOutOfRange)
{
    EXPECT_EQ(refusal({{DeviceEnd::proximal, 3e-3, 0.2}, {DeviceEnd::distal, 3e-3, 0.0}}),
              "accepted");
    EXPECT_EQ(refusal({{DeviceEnd::proximal, 0.0, 0.2}}),
              "incomplete_opening: length = 0 mm; it must be positive");
    EXPECT_EQ(refusal({{DeviceEnd::proximal, 3e-3, 0.9}}),
              "incomplete_opening: shrink = 0.9; allowed are 0 (fully open) to 0.8");
    EXPECT_EQ(
        refusal({{.length = 3e-3, .shrink = 0.2, .lean = 1.1}}),
        "incomplete_opening: lean = 1.1; allowed are 0 (about the axis) to 1 (one side on the "
        "wall)");
    EXPECT_EQ(refusal({{.length = 3e-3, .shrink = 0.2, .lean_angle = std::nan("")}}),
              "incomplete_opening: lean_angle must be a finite angle");
    EXPECT_EQ(refusal({{DeviceEnd::distal, 3e-3, 0.2}, {DeviceEnd::distal, 2e-3, 0.1}}),
              "incomplete_opening: the distal end is given twice; keep one of them");
}

}  // namespace braidzone
