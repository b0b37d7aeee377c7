#include "core/error.hpp"
#include "core/vector.hpp"
#include "deploy/braid_lattice.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

namespace braidzone {

using test::pipeline_4x20;

// pi 2 mm / 24 = 0.261799 mm; times 0.40 = 0.104720 mm; 20 mm / 0.104720 mm = 190.99 gaps.
TEST(MakeLattice, ReproducesTheCrossingsOfA4x20DeviceWith48Wires)
{
    const BraidLattice lattice = make_lattice(pipeline_4x20());
    EXPECT_EQ(lattice.nodes_per_ring, 24);
    EXPECT_EQ(lattice.num_rings, 192);
    EXPECT_NEAR(lattice.arm_width, 0.261799e-3, 1e-9);
    EXPECT_NEAR(lattice.ring_spacing, 0.104720e-3, 1e-9);
}

// Pore density of a uniform braid: N^2 tan(alpha) / (8 pi^2 R^2), alpha from the axis,
// tan(alpha) = 1 / t: 48^2 / (0.40 8 pi^2 (2 mm)^2) = 18.24 per mm^2.
TEST(MakeLattice, HasOneNodeForEachCrossing)
{
    const BraidLattice lattice = make_lattice(pipeline_4x20());
    const double density = 48.0 * 48.0 / (0.40 * 8.0 * std::pow(std::numbers::pi * 2e-3, 2));
    EXPECT_NEAR(1.0 / lattice.node_area(), density, 1e-9 * density);
}

TEST(MakeLattice, IsForceFreeAtNominalDiameterAndSpacing)
{
    const BraidLattice lattice = make_lattice(pipeline_4x20());
    const double chord = 2.0 * 2e-3 * std::sin(0.5 * std::numbers::pi / 24);
    EXPECT_NEAR(lattice.arm_length, std::hypot(lattice.ring_spacing, chord), 1e-18);
}

TEST(MakeLattice, KeepsThreeRingsForTheShortestDevice)
{
    FlowDiverter device = pipeline_4x20();
    device.nominal_length = 0.05e-3;
    EXPECT_EQ(make_lattice(device).num_rings, 3);
}

// 36 gaps of 20 mm / 36 = 0.555556 mm; arcs of 3 * 2 pi 2 mm / 24 = 1.570796 mm, so that l0 =
// sqrt(0.555556^2 + 1.570796^2) = 1.666147 mm.
TEST(MakeLattice, ReproducesTheLatticeOfThePaper)
{
    const BraidLattice lattice = make_lattice(pipeline_4x20(), LatticeKind::paper_2020);
    EXPECT_EQ(lattice.nodes_per_ring, 24);
    EXPECT_EQ(lattice.num_rings, 37);
    EXPECT_NEAR(lattice.ring_spacing, 0.555556e-3, 1e-9);
    EXPECT_NEAR(lattice.arm_length, 1.666147e-3, 1e-9);
    EXPECT_EQ(lattice.angle(5, 7), lattice.angle(6, 7));
}

// At 2.1 mm at the ends and 2 mm in the middle, no arm is longer or shorter than at rest.
TEST(MakeLattice, LetsAFlareRestWithoutStretchingAnArm)
{
    FlowDiverter device = pipeline_4x20();
    device.distal_flare = 0.1e-3;
    device.proximal_flare = -0.2e-3;
    device.flare_length = 2e-3;
    const BraidLattice lattice = make_lattice(device);
    EXPECT_DOUBLE_EQ(lattice.rest_radius(0), 2.1e-3);
    EXPECT_DOUBLE_EQ(lattice.rest_radius(lattice.num_rings / 2), 2e-3);
    EXPECT_DOUBLE_EQ(lattice.rest_radius(lattice.num_rings - 1), 1.8e-3);
    for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
        const auto place = [&](int k, int column, double z) {
            const double angle = lattice.angle(k, column);
            return Vec3(lattice.rest_radius(k) * std::cos(angle),
                        lattice.rest_radius(k) * std::sin(angle), z);
        };
        const double z = lattice.gap_spacing(ring);
        for (int step : lattice.arm_steps) {
            EXPECT_NEAR((place(ring + 1, 3 + step, z) - place(ring, 3, 0.0)).norm(),
                        lattice.arm_length, 1e-15);
        }
    }
    EXPECT_LT(lattice.gap_spacing(0), lattice.ring_spacing);
    EXPECT_GT(lattice.gap_spacing(lattice.num_rings - 2), lattice.ring_spacing);
}

// The paper's lattice of a 4 x 20 mm device, t = 0.354, opens less than the crossings, t = 0.40: to
// 2 mm sqrt(1 + 0.354^2) = 2.1214 mm against 2.154 mm.
TEST(MakeLattice, RefusesAFlareToWhichTheBraidCannotOpen)
{
    FlowDiverter device = pipeline_4x20();
    device.proximal_flare = 0.15e-3;
    device.flare_length = 4e-3;
    EXPECT_NO_THROW(make_lattice(device));
    try {
        make_lattice(device, LatticeKind::paper_2020);
        FAIL() << "no ConfigError";
    } catch (const ConfigError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("device.proximal_flare: the braid cannot lie"), std::string::npos)
            << message;
        EXPECT_NE(message.find("opens to 2.1214 mm"), std::string::npos) << message;
    }
}

// A quarter of each rhombus goes to each of its corners, so the shares add up to the rhombi.
TEST(AreaShare, AddsUpToTheRhombi)
{
    for (double length : {0.05e-3, 0.3e-3, 20e-3}) {
        FlowDiverter device = pipeline_4x20();
        device.nominal_length = length;
        const BraidLattice lattice = make_lattice(device);
        double shares = 0.0;
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            shares += lattice.nodes_per_ring * lattice.area_share(ring);
        }
        EXPECT_DOUBLE_EQ(shares, lattice.num_rhombi()) << length;
    }
}

TEST(RhombusCorners, FormOneConnectedLatticeInWhichEveryNodeIsReached)
{
    const BraidLattice lattice = make_lattice(pipeline_4x20());
    std::set<int> reached;
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            for (int corner : rhombus_corners(lattice, ring, column))
                reached.insert(corner);
        }
    }
    EXPECT_EQ(static_cast<int>(reached.size()), lattice.num_nodes());
}

// Opposite corners of a rhombus stand at the same angle (0 and 2) and at the same ring (1 and 3),
// one node spacing apart.
TEST(RhombusCorners, AreStaggeredByHalfANodeSpacing)
{
    const BraidLattice lattice = make_lattice(pipeline_4x20());
    const double node_spacing = 2.0 * std::numbers::pi / 24;
    const auto angle_of = [&](int node) {
        return lattice.angle(node / lattice.nodes_per_ring, node % lattice.nodes_per_ring);
    };
    const auto corners = rhombus_corners(lattice, 7, 5);
    EXPECT_NEAR(angle_of(corners[0]), angle_of(corners[2]), 1e-12);
    EXPECT_NEAR(angle_of(corners[3]) - angle_of(corners[1]), node_spacing, 1e-12);
    EXPECT_EQ(corners[1] / lattice.nodes_per_ring, 8);
    EXPECT_EQ(corners[3] / lattice.nodes_per_ring, 8);
}

}  // namespace braidzone
