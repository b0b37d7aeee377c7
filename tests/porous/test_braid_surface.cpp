#include "porous/braid_surface.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace braidzone {
namespace {

/// The force-free device, distal end at z = 20 mm.
Deployment force_free(const FlowDiverter& device)
{
    const BraidLattice lattice = make_lattice(device);
    return test::braid_on_cylinder(device, lattice.nominal_radius, lattice.ring_spacing, 20e-3);
}

TEST(MakeBraidSurface, HoldsOneEntryForEachRhombus)
{
    const FlowDiverter device = test::pipeline_4x20();
    const Deployment deployment = force_free(device);
    const BraidSurface surface = make_braid_surface(deployment, device);
    const auto count = static_cast<std::size_t>(deployment.lattice.num_rhombi());
    EXPECT_EQ(surface.rhombi.size(), count);
    EXPECT_EQ(surface.centres.size(), count);
    EXPECT_EQ(surface.normals.size(), count);
    EXPECT_EQ(surface.wire_length.size(), count);
    EXPECT_EQ(surface.points.size(), deployment.nodes.size());
    for (const Rhombus& rhombus : surface.rhombi)
        EXPECT_EQ(rhombus.wire_diameter, device.wire_diameter);
}

TEST(MakeBraidSurface, ForceFreeDeviceHasNoDensityIncrease)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidSurface surface = make_braid_surface(force_free(device), device);
    for (const double increase : surface.density_increase)
        EXPECT_NEAR(increase, 0.0, 1e-12);
}

// Rings at half the spacing: half the area, twice the density.
TEST(MakeBraidSurface, CompressionRaisesTheDensity)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const BraidSurface surface = make_braid_surface(
        test::braid_on_cylinder(device, lattice.nominal_radius, 0.5 * lattice.ring_spacing, 20e-3),
        device);
    for (const double increase : surface.density_increase)
        EXPECT_NEAR(increase, 1.0, 1e-12);
}

TEST(MakeBraidSurface, NormalsPointFromTheAxisToTheWall)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidSurface surface = make_braid_surface(force_free(device), device);
    for (std::size_t i = 0; i < surface.normals.size(); ++i) {
        const Vec3& centre = surface.centres[i];
        const Vec3 outward = Vec3(centre.x(), centre.y(), 0.0).normalized();
        EXPECT_NEAR(surface.normals[i].dot(outward), 1.0, 1e-12);
    }
}

// A right-handed helix advances along +z as it turns anticlockwise about +z.
TEST(MakeBraidSurface, EdgesLieAlongTheirFamilies)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidSurface surface = make_braid_surface(force_free(device), device);
    for (std::size_t i = 0; i < surface.rhombi.size(); ++i) {
        const Vec3 around = Vec3::UnitZ().cross(surface.normals[i]);
        const Vec3& a = surface.rhombi[i].edge_a;
        const Vec3& b = surface.rhombi[i].edge_b;
        EXPECT_GT(a.dot(around) * a.z(), 0.0);
        EXPECT_LT(b.dot(around) * b.z(), 0.0);
    }
}

// The tangent of the angle is ring spacing over the half chord R sin(pi / n).
TEST(MakeBraidSurface, BraidAngleIsMeasuredFromTheCircumference)
{
    const FlowDiverter device = test::pipeline_4x20();
    const Deployment deployment = force_free(device);
    const BraidSurface surface = make_braid_surface(deployment, device);
    const double half_chord = 2e-3 * std::sin(std::numbers::pi / 24);
    const double angle = std::atan2(deployment.lattice.ring_spacing, half_chord);
    for (const Rhombus& rhombus : surface.rhombi)
        EXPECT_NEAR(rhombus.braid_angle, angle, 1e-12);
}

TEST(MakeBraidSurface, AveragesTheCornersOfEachRhombus)
{
    const FlowDiverter device = test::pipeline_4x20();
    Deployment deployment = force_free(device);
    for (std::size_t node = 0; node < deployment.nodes.size(); ++node) {
        deployment.contact_pressure[node] = static_cast<double>(node);
        deployment.wall_distance[node] = 2.0 * static_cast<double>(node);
    }
    const BraidSurface surface = make_braid_surface(deployment, device);
    // Rhombus (ring 1, column 3): nodes (1, 3), (2, 2), (3, 2), (2, 3) of 24 a ring.
    const double mean = (27.0 + 50.0 + 74.0 + 51.0) / 4.0;
    EXPECT_DOUBLE_EQ(surface.contact_pressure[24 + 3], mean);
    EXPECT_DOUBLE_EQ(surface.wall_distance[24 + 3], 2.0 * mean);
}

// Every wire is a chain of N - 1 equal chords; there are as many wires as the device has. The end
// arms belong to one rhombus only and must not be lost.
TEST(Measure, WireLengthIsThatOfAllArms)
{
    const FlowDiverter device = test::pipeline_4x20();
    const Deployment deployment = force_free(device);
    const BraidLattice& lattice = deployment.lattice;
    const BraidMeasures measures = measure(make_braid_surface(deployment, device));
    const double chord = std::hypot(
        lattice.ring_spacing,
        2.0 * lattice.nominal_radius * std::sin(0.5 * std::numbers::pi / lattice.nodes_per_ring));
    const double all_arms = device.num_wires * (lattice.num_rings - 1) * chord;
    EXPECT_NEAR(measures.wire_length, all_arms, 1e-12 * all_arms);
    const double cross_section = 0.25 * std::numbers::pi * 30e-6 * 30e-6;
    EXPECT_NEAR(measures.metal_volume, cross_section * all_arms, 1e-12 * cross_section * all_arms);
}

// Around a flat sheet of 3 x 2 square cells of 1 mm run 10 sides, and within it 7 more: 17 mm.
TEST(Measure, WireLengthOfASheetCountsItsEdgesOnce)
{
    const BraidSurface sheet =
        test::flat_braid(Vec3::Zero(), Vec3(1e-3, 0, 0), 3, Vec3(0, 1e-3, 0), 2, 30e-6);
    EXPECT_NEAR(measure(sheet).wire_length, 17e-3, 1e-15);
    EXPECT_NEAR(measure(sheet).device_area, 6e-6, 1e-18);
}

TEST(Measure, NeckFiguresAreAbsentWithoutANeck)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const BraidSurface apposed = make_braid_surface(
        test::braid_on_cylinder(device, lattice.nominal_radius, lattice.ring_spacing, 20e-3, 1e-6),
        device);
    const BraidMeasures measures = measure(apposed);
    EXPECT_FALSE(measures.mean_metal_coverage_neck.has_value());
    EXPECT_FALSE(measures.mean_density_increase_neck.has_value());
    EXPECT_FALSE(measures.mean_pore_density_neck.has_value());
}

// Two strips of cells of 1 and 3 mm^2 with the wall far from the second one: means by area.
TEST(Measure, WeighsByAreaAndSeparatesTheNeck)
{
    BraidSurface surface =
        test::flat_braid(Vec3::Zero(), Vec3(1e-3, 0, 0), 1, Vec3(0, 1e-3, 0), 1, 100e-6);
    const BraidSurface wide =
        test::flat_braid(Vec3::Zero(), Vec3(3e-3, 0, 0), 1, Vec3(0, 1e-3, 0), 1, 100e-6);
    surface.rhombi.push_back(wide.rhombi[0]);
    surface.density_increase = {0.0, 1.0};
    surface.wire_length.push_back(0.0);
    const BraidMeasures measures = measure(surface, {NeckPart::opposite, NeckPart::over});
    EXPECT_NEAR(measures.mean_density_increase, 0.75, 1e-12);
    // s = 0.1 and 0.1; 0.1 (the rows along the long side are 1 mm apart) and 1/30.
    const double coverage_narrow = 0.19, coverage_wide = 0.1 + 1.0 / 30.0 - 0.1 / 30.0;
    EXPECT_NEAR(measures.mean_metal_coverage, (coverage_narrow + 3.0 * coverage_wide) / 4.0, 1e-12);
    EXPECT_NEAR(measures.mean_metal_coverage_neck.value(), coverage_wide, 1e-12);
    EXPECT_NEAR(measures.mean_density_increase_neck.value(), 1.0, 1e-12);
    EXPECT_NEAR(measures.mean_density_increase_neck_rings.value(), 0.75, 1e-12);
    EXPECT_NEAR(measures.mean_pore_density_neck.value(), 1.0 / 3e-6, 1e-6);
}

// A sheet of two cells (six points) before one of one cell (four): its corners count from 6.
TEST(Joined, HoldsBothSurfacesOneAfterTheOther)
{
    const BraidSurface first =
        test::flat_braid(Vec3::Zero(), Vec3(1e-3, 0, 0), 2, Vec3(0, 1e-3, 0), 1, 30e-6);
    const BraidSurface second =
        test::flat_braid(Vec3(0, 0, 5e-3), Vec3(2e-3, 0, 0), 1, Vec3(0, 1e-3, 0), 1, 20e-6);
    const BraidSurface both = joined(first, second);
    ASSERT_EQ(both.points.size(), 10U);
    ASSERT_EQ(both.corners.size(), 3U);
    EXPECT_EQ(both.corners[1], (std::array<int, 4>{1, 2, 5, 4}));
    EXPECT_EQ(both.corners[2], (std::array<int, 4>{6, 7, 9, 8}));
    EXPECT_EQ(both.points[7], Vec3(2e-3, 0, 5e-3));
    EXPECT_EQ(both.rhombi[1].wire_diameter, 30e-6);
    EXPECT_EQ(both.rhombi[2].wire_diameter, 20e-6);
    EXPECT_LT((both.centres[2] - Vec3(1e-3, 0.5e-3, 5e-3)).norm(), 1e-15);
    for (const std::size_t count :
         {both.rhombi.size(), both.normals.size(), both.density_increase.size(),
          both.contact_pressure.size(), both.wall_distance.size(), both.wire_length.size()}) {
        EXPECT_EQ(count, 3U);
    }
    // 7 sides of 1 mm, and 2 x 2 + 2 x 1 mm; areas 2 + 2 mm^2.
    const BraidMeasures measures = measure(both);
    EXPECT_NEAR(measures.wire_length, 13e-3, 1e-15);
    EXPECT_NEAR(measures.device_area, 4e-6, 1e-18);
    EXPECT_NEAR(measures.metal_volume, 0.25 * std::numbers::pi * (7e-3 * 900e-12 + 6e-3 * 400e-12),
                1e-18);
}

// Three nodes of rhombus (10, 4): its corners (10, 4), (11, 3), (11, 4). No other rhombus has three
// of them; the neck's rings 10 and 11 are the middle ones of the rhombi of rings 9 and 10.
TEST(NeckParts, AreOverTheNeckWithThreeCornersAndOppositeInItsRings)
{
    const Deployment deployment = force_free(test::pipeline_4x20());
    const BraidLattice& lattice = deployment.lattice;
    WallOpening neck;
    neck.nodes = {lattice.node(10, 4), lattice.node(11, 3), lattice.node(11, 4)};
    neck.distal_ring = 10;
    neck.proximal_ring = 11;
    const std::vector<NeckPart> parts = neck_parts(deployment, {neck});
    ASSERT_EQ(parts.size(), static_cast<std::size_t>(lattice.num_rhombi()));
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const NeckPart expected = ring == 10 && column == 4 ? NeckPart::over
                                      : ring == 9 || ring == 10 ? NeckPart::opposite
                                                                : NeckPart::none;
            EXPECT_EQ(parts[static_cast<std::size_t>(lattice.node(ring, column))], expected)
                << "ring " << ring << ", column " << column;
        }
    }
}

TEST(NeckParts, ComeFromTheFirstOpeningAlone)
{
    const Deployment deployment = force_free(test::pipeline_4x20());
    const BraidLattice& lattice = deployment.lattice;
    WallOpening neck, branch;
    neck.distal_ring = neck.proximal_ring = 20;
    neck.nodes = {lattice.node(20, 0)};
    branch.distal_ring = branch.proximal_ring = 60;
    const auto corners = rhombus_corners(lattice, 59, 7);
    branch.nodes.assign(corners.begin(), corners.end());
    const std::vector<NeckPart> parts = neck_parts(deployment, {neck, branch});
    EXPECT_EQ(parts[static_cast<std::size_t>(lattice.node(59, 7))], NeckPart::none);
    EXPECT_EQ(parts[static_cast<std::size_t>(lattice.node(19, 7))], NeckPart::opposite);
    const std::vector<NeckPart> without = neck_parts(deployment, {});
    EXPECT_EQ(std::count(without.begin(), without.end(), NeckPart::none), lattice.num_rhombi());
}

}  // namespace
}  // namespace braidzone
