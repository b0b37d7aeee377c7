#include "deploy/crimped_braid.hpp"
#include "deploy/deployment_measures.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace braidzone {

namespace {

constexpr double tube_radius = 2.2e-3;
constexpr double ring_radius = 1.9e-3;

/// A 4 x 4 mm device by hand: every ring a circle of 1.9 mm at nominal spacing in a wider tube.
Deployment uniform_deployment()
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 4e-3;
    Deployment deployment;
    deployment.lattice = make_lattice(device);
    const Centerline axis = test::tube_centerline(tube_radius, 10e-3);
    for (int ring = 0; ring < deployment.lattice.num_rings; ++ring) {
        deployment.ring_arc_length.push_back(8e-3 - ring * deployment.lattice.ring_spacing);
        deployment.rings.push_back(section_at(axis, deployment.ring_arc_length.back()));
    }
    const CrimpedBraid braid = crimp(deployment.lattice, deployment.rings, ring_radius);
    const std::size_t count = braid.rays.size();
    for (std::size_t node = 0; node < count; ++node) {
        deployment.nodes.push_back(on_ray(braid, static_cast<int>(node), ring_radius));
    }
    deployment.in_contact.assign(count, 0);
    deployment.wall_distance.assign(count, tube_radius - ring_radius);
    deployment.contact_force.assign(count, 0.0);
    deployment.contact_pressure.assign(count, 0.0);
    return deployment;
}

DeploymentMeasures measure_in_tube(const Deployment& deployment,
                                   const std::vector<WallOpening>& openings = {})
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 4e-3;
    return measure(deployment, device, WallTree(test::tube_vessel(tube_radius, 10e-3)), 60e-6,
                   openings);
}

}  // namespace

// Rhombi between circles of radius R: diagonals 2 R sin(pi / n) and 2 dL, half their product each.
TEST(NodeAreas, SumToTheAreaOfTheRhombi)
{
    const Deployment deployment = uniform_deployment();
    const BraidLattice& lattice = deployment.lattice;
    const double rhombus = 2.0 * ring_radius * std::sin(std::numbers::pi / lattice.nodes_per_ring) *
                           lattice.ring_spacing;
    const std::vector<double> areas = node_areas(lattice, deployment.nodes);
    const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
    EXPECT_NEAR(sum, lattice.num_rhombi() * rhombus, 1e-9 * sum);
    EXPECT_NEAR(areas[static_cast<std::size_t>(lattice.node(10, 4))], rhombus, 1e-9 * rhombus);
    EXPECT_NEAR(areas[static_cast<std::size_t>(lattice.node(0, 4))], 0.25 * rhombus,
                1e-9 * rhombus);
}

TEST(RadialExpansion, IsTheDistanceToTheCentreOfTheRing)
{
    for (double expansion : radial_expansion(uniform_deployment())) {
        EXPECT_NEAR(expansion, ring_radius, 1e-12);
    }
}

TEST(InvertedRhombi, AreNoneInASoundBraidAndFoundInAFoldedOne)
{
    Deployment deployment = uniform_deployment();
    EXPECT_TRUE(inverted_rhombi(deployment).empty());
    // Two nodes of a rhombus's ring change places: its winding turns over.
    const auto corners = rhombus_corners(deployment.lattice, 10, 4);
    std::swap(deployment.nodes[static_cast<std::size_t>(corners[1])],
              deployment.nodes[static_cast<std::size_t>(corners[3])]);
    const std::vector<int> inverted = inverted_rhombi(deployment);
    EXPECT_NE(
        std::find(inverted.begin(), inverted.end(), 10 * deployment.lattice.nodes_per_ring + 4),
        inverted.end());
}

TEST(Measure, GivesHandValuesForAUniformBraid)
{
    Deployment deployment = uniform_deployment();
    // Ring 10 touches the wall with 1 mN a node.
    for (int column = 0; column < 24; ++column) {
        const std::size_t node = static_cast<std::size_t>(deployment.lattice.node(10, column));
        deployment.in_contact[node] = 1;
        deployment.contact_force[node] = 1e-3;
    }
    // A neck of one node, on ring 20: it is not malapposed.
    const int over_neck = deployment.lattice.node(20, 3);
    const WallOpening neck{{over_neck}, 20, 20, 1e-6};
    const DeploymentMeasures figures = measure_in_tube(deployment, {neck});
    const double spacing = deployment.lattice.ring_spacing;
    const int gaps = deployment.lattice.num_rings - 1;
    EXPECT_NEAR(figures.implanted_length, gaps * spacing, 1e-12);
    // L(R) at R / R0 = 0.69 / 4: sqrt(0.16 + 1 - 0.029756) / 0.4 = 2.65783.
    EXPECT_NEAR(figures.foreshortening, 1.0 - 1.0 / 2.65783, 1e-5);
    EXPECT_NEAR(figures.radial_force_per_length, 24e-3 / (gaps * spacing), 1e-9);
    const double ring_area = 24 * 2.0 * ring_radius * std::sin(std::numbers::pi / 24) * spacing;
    EXPECT_NEAR(figures.mean_contact_pressure, 24e-3 / ring_area, 1e-6 * 24e-3 / ring_area);
    EXPECT_NEAR(figures.contact_area_fraction, ring_area / figures.device_area, 1e-9);
    EXPECT_NEAR(figures.malapposed_area, figures.device_area - ring_area - ring_area / 24, 1e-15);
    EXPECT_NEAR(figures.mean_radial_expansion_neck.value(), ring_radius, 1e-12);
    EXPECT_EQ(figures.nodes_outside_vessel, 0);
}

TEST(Measure, CountsNodesOutsideTheVessel)
{
    Deployment deployment = uniform_deployment();
    deployment.nodes[100] = Vec3(3e-3, 0, 5e-3);
    EXPECT_EQ(measure_in_tube(deployment).nodes_outside_vessel, 1);
}

TEST(Measure, HasNoNeckWhenEveryNodeTouches)
{
    Deployment deployment = uniform_deployment();
    deployment.in_contact.assign(deployment.nodes.size(), 1);
    const DeploymentMeasures figures = measure_in_tube(deployment);
    EXPECT_FALSE(figures.mean_radial_expansion_neck.has_value());
    EXPECT_NEAR(figures.contact_area_fraction, 1.0, 1e-12);
}

// In the catheter the device is 2.65783 times as long as the 4 mm of its label (see above).
TEST(Measure, TakesForeshorteningAgainstTheLabelToo)
{
    const Deployment deployment = uniform_deployment();
    const DeploymentMeasures figures = measure_in_tube(deployment);
    const double implanted = (deployment.lattice.num_rings - 1) * deployment.lattice.ring_spacing;
    EXPECT_NEAR(figures.foreshortening_label, 1.0 - implanted / 4e-3, 1e-12);
}

// A node that stands for A0 = dL0 2 pi R0 / n when force-free, whatever its deployed area.
TEST(Measure, GivesContactPressureOverTheForceFreeAreaToo)
{
    Deployment deployment = uniform_deployment();
    const BraidLattice& lattice = deployment.lattice;
    const double inner = lattice.ring_spacing * 2.0 * std::numbers::pi * 2e-3 / 24;
    for (const int ring : {0, 10}) {
        const auto node = static_cast<std::size_t>(lattice.node(ring, 5));
        deployment.in_contact[node] = 1;
        deployment.contact_force[node] = 2e-5;
    }
    // A node of the end ring is a corner of one rhombus out of four.
    const double reference = 4e-5 / (1.25 * inner);
    EXPECT_NEAR(measure_in_tube(deployment).mean_contact_pressure_reference, reference,
                1e-9 * reference);
}

// Rings 8 to 12 are the neck's. Contact: all of ring 2 with 1 mN a node, half of ring 10 with
// 2 mN, none proximal. Inner rings are alike in area; ring 0 has a quarter of it and ring 1 three.
TEST(Measure, SplitsContactAndForceByZone)
{
    Deployment deployment = uniform_deployment();
    const BraidLattice& lattice = deployment.lattice;
    for (int column = 0; column < 24; ++column) {
        const auto distal = static_cast<std::size_t>(lattice.node(2, column));
        deployment.in_contact[distal] = 1;
        deployment.contact_force[distal] = 1e-3;
        const auto middle = static_cast<std::size_t>(lattice.node(10, column));
        deployment.in_contact[middle] = column < 12 ? 1 : 0;
        deployment.contact_force[middle] = column < 12 ? 2e-3 : 0.0;
    }
    const WallOpening neck{{lattice.node(8, 3), lattice.node(12, 3)}, 8, 12, 3e-6};
    const DeploymentMeasures figures = measure_in_tube(deployment, {neck});
    const double spacing = lattice.ring_spacing;
    ASSERT_TRUE(figures.distal_landing && figures.neck && figures.proximal_landing);
    // Of 1/4 + 3/4 + 6 rings; of 5 rings. Rings stand for a spacing each, the first for half.
    EXPECT_NEAR(figures.distal_landing->contact_area_fraction, 1.0 / 7.0, 1e-9);
    EXPECT_NEAR(figures.neck->contact_area_fraction, 0.5 / 5.0, 1e-9);
    EXPECT_EQ(figures.proximal_landing->contact_area_fraction, 0.0);
    EXPECT_NEAR(figures.distal_landing->radial_force_per_length, 24e-3 / (7.5 * spacing), 1e-6);
    EXPECT_NEAR(figures.neck->radial_force_per_length, 24e-3 / (5.0 * spacing), 1e-6);
    EXPECT_EQ(figures.proximal_landing->radial_force_per_length, 0.0);
    EXPECT_DOUBLE_EQ(figures.neck_area.value(), 3e-6);
    EXPECT_NEAR(figures.neck_range->from, 8e-3 - 12 * spacing, 1e-12);
    EXPECT_NEAR(figures.neck_range->to, 8e-3 - 8 * spacing, 1e-12);
}

TEST(Measure, HasNoLandingZoneWhereTheNeckReachesTheEnd)
{
    const Deployment deployment = uniform_deployment();
    const int last = deployment.lattice.num_rings - 1;
    const DeploymentMeasures distal = measure_in_tube(deployment, {{{3}, 0, 5, 1e-6}});
    EXPECT_FALSE(distal.distal_landing.has_value());
    EXPECT_TRUE(distal.proximal_landing.has_value());
    const DeploymentMeasures all = measure_in_tube(deployment, {{{3}, 0, last, 1e-6}});
    EXPECT_FALSE(all.distal_landing.has_value());
    EXPECT_FALSE(all.proximal_landing.has_value());
    EXPECT_TRUE(all.neck.has_value());
    const DeploymentMeasures none = measure_in_tube(deployment);
    EXPECT_FALSE(none.neck || none.neck_area || none.neck_range || none.distal_landing);
}

// A neck that was given where nothing opens has a zone, but no node to average over.
TEST(Measure, HasNoNeckExpansionWithoutANodeOverTheNeck)
{
    const DeploymentMeasures figures = measure_in_tube(uniform_deployment(), {{{}, 8, 12, 0.0}});
    EXPECT_FALSE(figures.mean_radial_expansion_neck.has_value());
    EXPECT_TRUE(figures.neck.has_value());
    EXPECT_EQ(figures.neck_area.value(), 0.0);
}

// 21 inner nodes of equal area are off the wall, 20 of them by 0.1 mm and one by 0.5 mm: 95.2 % of
// the area are within 0.1 mm, and the mean is 2.5 / 21 mm.
TEST(Measure, GivesStatisticsOfTheGapsOverTheMalapposedArea)
{
    Deployment deployment = uniform_deployment();
    deployment.wall_distance.assign(deployment.nodes.size(), 0.0);
    for (int column = 0; column < 21; ++column) {
        deployment.wall_distance[static_cast<std::size_t>(deployment.lattice.node(10, column))] =
            column == 7 ? 0.5e-3 : 0.1e-3;
    }
    const DeploymentMeasures figures = measure_in_tube(deployment);
    ASSERT_TRUE(figures.malapposition_gap.has_value());
    EXPECT_NEAR(figures.malapposition_gap->mean, 2.5e-3 / 21.0, 1e-12);
    EXPECT_DOUBLE_EQ(figures.malapposition_gap->percentile_95, 0.1e-3);
    EXPECT_DOUBLE_EQ(figures.malapposition_gap->max, 0.5e-3);

    // With four at 0.5 mm out of 21 the 95th percentile is theirs.
    for (const int column : {8, 9, 10})
        deployment.wall_distance[static_cast<std::size_t>(deployment.lattice.node(10, column))] =
            0.5e-3;
    EXPECT_DOUBLE_EQ(measure_in_tube(deployment).malapposition_gap->percentile_95, 0.5e-3);
}

TEST(Measure, CountsNoGapOverAnOpeningNorWithinTheAllowedOne)
{
    Deployment deployment = uniform_deployment();
    deployment.wall_distance.assign(deployment.nodes.size(), 50e-6);  // 60 um are allowed
    deployment.wall_distance[250] = 1e-3;
    const DeploymentMeasures figures = measure_in_tube(deployment, {{{250}, 10, 10, 1e-6}});
    EXPECT_FALSE(figures.malapposition_gap.has_value());
    EXPECT_EQ(figures.malapposed_area, 0.0);
}

}  // namespace braidzone
