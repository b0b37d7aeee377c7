#include "deploy/wall_contact.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

CrimpedBraid crimped_in_tube(double radius)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 4e-3;
    const BraidLattice lattice = make_lattice(device);
    const Centerline axis = test::tube_centerline(radius, 10e-3);
    std::vector<CrossSection> rings;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        rings.push_back(section_at(axis, 8e-3 - ring * lattice.ring_spacing));
    }
    return crimp(lattice, rings, 0.345e-3);
}

}  // namespace

TEST(Crimp, PutsTheNodesOnCirclesInThePlanesOfTheirRings)
{
    const CrimpedBraid braid = crimped_in_tube(1.8e-3);
    for (int node = 0; node < braid.lattice.num_nodes(); ++node) {
        const Vec3 place = on_ray(braid, node, braid.radius);
        const int ring = node / braid.lattice.nodes_per_ring;
        EXPECT_NEAR(std::hypot(place.x(), place.y()), 0.345e-3, 1e-12);
        EXPECT_NEAR(place.z(), 8e-3 - ring * braid.lattice.ring_spacing, 1e-9);
    }
}

// A prism of 96 sides around the circle of 1.8 mm: its sides are between 1.8 cos(pi / 96) and 1.8
// mm from the axis; 2 um less across a side is at most 2 um / cos(pi / 96) less along the ray.
TEST(WallStops, LieTheOffsetInsideATube)
{
    const double radius = 1.8e-3, offset = 2e-6;
    const Vessel vessel = test::tube_vessel(radius, 10e-3, 96);
    const CrimpedBraid braid = crimped_in_tube(radius);
    const double apothem = radius * std::cos(std::numbers::pi / 96);
    for (double stop : wall_stops(braid, WallTree(vessel), 4e-3, offset)) {
        EXPECT_GE(stop, apothem - 1.001 * offset);
        EXPECT_LE(stop, radius - offset);
    }
}

TEST(WallStops, AreTheReachWhereThereIsNoWallWithinIt)
{
    const Vessel vessel = test::tube_vessel(1.8e-3, 10e-3);
    for (double stop : wall_stops(crimped_in_tube(1.8e-3), WallTree(vessel), 1.5e-3, 2e-6)) {
        EXPECT_EQ(stop, 1.5e-3);
    }
}

}  // namespace braidzone
