#include "deploy/wire_jam.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace braidzone {
namespace {

/// Three rings of a 4 x 20 mm Pipeline, 0.2 mm apart along z; the planes of the outer ones lean by
/// `angle` towards the middle one on the side of +x.
CrimpedBraid leaning_rings(double angle)
{
    FlowDiverter device = test::pipeline_4x20();
    BraidLattice lattice = make_lattice(device);
    lattice.num_rings = 3;
    std::vector<CrossSection> rings(3);
    for (int ring = 0; ring < 3; ++ring) {
        CrossSection& section = rings[static_cast<std::size_t>(ring)];
        const double lean = (1 - ring) * angle;
        section.origin = Vec3(0, 0, (1 - ring) * 0.2e-3);
        section.tangent = Vec3(std::sin(lean), 0, std::cos(lean));
        section.normal = Vec3(std::cos(lean), 0, -std::sin(lean));
        section.binormal = section.tangent.cross(section.normal);
    }
    return crimp(lattice, rings, 0.3e-3);
}

}  // namespace

// Rhombi of diagonals 2 x 30 and 2 x 40 um have sides of 50 um and the height 2400 / 50 = 48 um.
TEST(TouchingSpacing, IsThatOfARhombusAsHighAsAWire)
{
    EXPECT_NEAR(touching_spacing(48e-6, 40e-6), 30e-6, 1e-15);
}

// 4 / 0.03^2 = 4444.44 and 1 / 0.2618^2 = 14.59 per mm^2: 1 / sqrt(4429.85) mm = 15.025 um, and a
// tenth more.
TEST(LeastRingSpacing, IsHalfAWireForAPipeline)
{
    const FlowDiverter device = test::pipeline_4x20();
    EXPECT_NEAR(least_ring_spacing(device, make_lattice(device)), 1.1 * 15.025e-6, 1e-9);
}

// Rings of the paper's lattice are 5.3 times as far apart as the crossings: 20 / 36 mm by 0.4 pi 2
// / 24 mm.
TEST(LeastRingSpacing, GrowsWithTheSpacingOfACoarseLattice)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice coarse = make_lattice(device, LatticeKind::paper_2020);
    EXPECT_NEAR(least_ring_spacing(device, coarse), 5.3052 * 1.1 * 15.025e-6, 1e-8);
}

// A node of the middle ring at the angle phi meets the plane of an outer one, 0.2 mm cos 0.1 away
// along its normal, at r sin 0.1 cos phi; 20 um before that it stops.
TEST(JamStops, AreWhereThePlanesOfNeighboursComeNear)
{
    const CrimpedBraid braid = leaning_rings(0.1);
    const std::vector<double> stops = jam_stops(braid, 20e-6);
    for (int column = 0; column < braid.lattice.nodes_per_ring; ++column) {
        const double cosine = std::cos(braid.lattice.angle(1, column));
        const double stop = stops[static_cast<std::size_t>(braid.lattice.node(1, column))];
        if (cosine > 1e-6) {
            EXPECT_NEAR(stop, (0.2e-3 * std::cos(0.1) - 20e-6) / (std::sin(0.1) * cosine), 1e-12);
        } else if (cosine < -1e-6) {
            EXPECT_EQ(stop, std::numeric_limits<double>::infinity());
        }
    }
}

// The outer rings meet the middle one's plane, across z, at r sin 0.1 cos phi = 0.2 mm.
TEST(JamStops, HoldBothRingsOfAPair)
{
    const CrimpedBraid braid = leaning_rings(0.1);
    const std::vector<double> stops = jam_stops(braid, 20e-6);
    const double cosine = std::cos(braid.lattice.angle(0, 1));
    ASSERT_GT(cosine, 0.9);
    EXPECT_NEAR(stops[static_cast<std::size_t>(braid.lattice.node(0, 1))],
                0.18e-3 / (std::sin(0.1) * cosine), 1e-12);
}

TEST(JamStops, AreNoneBetweenParallelRingsAndNeverWithinTheCatheter)
{
    for (const double stop : jam_stops(leaning_rings(0.0), 20e-6))
        EXPECT_EQ(stop, std::numeric_limits<double>::infinity());
    // 0.2 mm / tan(1.2) = 0.08 mm from the hubs, less than the crimped radius.
    for (const double stop : jam_stops(leaning_rings(1.2), 20e-6))
        EXPECT_GE(stop, 0.3e-3);
}

// Rings nearer than the least spacing all round would not part, whatever the radius.
TEST(JamStops, DoNotHoldRingsWhoseHubsAreTooNear)
{
    for (const double stop : jam_stops(leaning_rings(0.1), 0.21e-3))
        EXPECT_EQ(stop, std::numeric_limits<double>::infinity());
}

TEST(NearerStop, IsTheNearerOfTwoThatAreFarApart)
{
    EXPECT_EQ(nearer_stop(1.8, 1.9, 0.1), 1.8);
    EXPECT_EQ(nearer_stop(2.5, 1.9, 0.1), 1.9);
    EXPECT_EQ(nearer_stop(1.8, std::numeric_limits<double>::infinity(), 0.1), 1.8);
}

// A quarter of the width before two equal ones; in between the slope goes from 0 to 1 evenly.
TEST(NearerStop, RoundsTheCornerOff)
{
    EXPECT_NEAR(nearer_stop(1.8, 1.8, 0.1), 1.775, 1e-12);
    const double step = 1e-6;
    const auto slope = [&](double a) {
        return (nearer_stop(a + step, 1.8, 0.1) - nearer_stop(a - step, 1.8, 0.1)) / (2.0 * step);
    };
    EXPECT_NEAR(slope(1.7), 1.0, 1e-4);
    EXPECT_NEAR(slope(1.75), 0.75, 1e-6);
    EXPECT_NEAR(slope(1.8), 0.5, 1e-6);
    EXPECT_NEAR(slope(1.9), 0.0, 1e-4);
}

}  // namespace braidzone
