#include "core/mesh_topology.hpp"
#include "core/surface_check.hpp"
#include "export/wire_tubes.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double pi = std::numbers::pi;

/// A braid of 48 wires of 30 um, 2 mm long, in a tube wide enough not to touch it.
class WireTubesTest : public testing::Test {
protected:
    WireTubesTest() { device.nominal_length = 2e-3; }

    Deployment braid(double radius = 2e-3) const
    {
        return test::braid_on_cylinder(device, radius, make_lattice(device).ring_spacing, 6e-3);
    }

    WireTubes tubes(const Deployment& deployment, int over = 2) const
    {
        WireTubeOptions options;
        options.pattern.over = over;
        const double room = half_thickness(options, device.wire_diameter) + 1.5e-6;
        return make_wire_tubes(deployment.lattice, inset_braid(deployment, wall, room),
                               device.wire_diameter, options);
    }

    FlowDiverter device = test::pipeline_4x20();
    Vessel vessel = test::tube_vessel(2.5e-3, 10e-3);
    WallTree wall{vessel};
};

// By CGAL: closed, consistent, outwards, and no two triangles of any two tubes meet.
TEST_F(WireTubesTest, AreClosedSolidsThatTouchNoOther)
{
    for (const int over : {1, 2, 3}) {
        const WireTubes all = tubes(braid(), over);
        EXPECT_TRUE(border_loops(all.mesh).empty());
        const SurfaceDefects defects = find_defects(all.mesh);
        EXPECT_EQ(defects.num_components, 48);
        EXPECT_TRUE(defects.degenerate_triangles.empty());
        EXPECT_TRUE(defects.non_manifold_edges.empty());
        EXPECT_TRUE(defects.inconsistent_edges.empty());
        EXPECT_TRUE(defects.intersecting_triangles.empty()) << describe(defects);
        EXPECT_GT(enclosed_volume(all.mesh), 0.0);
        EXPECT_EQ(all.num_overlaps, 0U);
        // A twentieth of the diameter where two wires cross, less what chords take off.
        EXPECT_NEAR(all.least_gap, 1.5e-6, 0.2e-6);
        EXPECT_EQ(all.mesh.triangles.size(),
                  num_wire_triangles(make_lattice(device), WireTubeOptions{}));
    }
}

/// Length of a wire that runs along a helix on a cylinder and goes over and under at heights of
/// +-h: the integral of sqrt((R + z)^2 w^2 + v^2 + z'^2) over the arms, by Simpson's rule.
double helix_length(double radius, double turn, double rise, double h, int over, int num_arms)
{
    const auto height = [&](double arms) {
        const auto at_crossing = [&](int k) { return k / over % 2 == 0 ? h : -h; };
        const int k = static_cast<int>(arms);
        const double from = at_crossing(k), to = at_crossing(k + 1);
        const double part = std::clamp(2.0 * (arms - k) - 0.5, 0.0, 1.0);
        return 0.5 * (from + to) + 0.5 * (from - to) * std::cos(pi * part);
    };
    const auto speed = [&](double arms) {
        constexpr double step = 1e-5;
        const double slope = (height(arms + step) - height(arms - step)) / (2.0 * step);
        return std::hypot((radius + height(arms)) * turn, rise, slope);
    };
    constexpr int parts = 200;
    double sum = 0.0;
    for (int i = 0; i < parts * num_arms; ++i) {
        const double at = (i + 0.5) / parts, half = 0.5 / parts;
        const double first = i == 0 ? at : at - half;
        sum += (speed(first) + 4.0 * speed(at) + speed(at + half)) / (6.0 * parts);
    }
    return sum;
}

// The polygon has the wire's area and the pieces are mitred, so the volume is pi d^2 / 4 times the
// length. What a polyline of six pieces an arm cuts off a curve is 0.1 % of it.
TEST_F(WireTubesTest, HoldTheMetalOfWiresThatGoOverAndUnder)
{
    const BraidLattice lattice = make_lattice(device);
    const double corner = 15e-6 * std::sqrt(pi / 4.0 / std::sin(pi / 4.0));
    for (const int over : {1, 2}) {
        const WireTubes all = tubes(braid(), over);
        const double length = 48.0 * helix_length(2e-3, pi / 24.0, lattice.ring_spacing,
                                                  corner + 0.75e-6, over, lattice.num_rings - 1);
        EXPECT_NEAR(all.length, length, 2e-3 * length);
        const double volume = length * pi * 15e-6 * 15e-6;
        EXPECT_NEAR(enclosed_volume(all.mesh), volume, 2e-3 * volume);
        EXPECT_NEAR(enclosed_volume(all.mesh), all.length * pi * 15e-6 * 15e-6, 1e-4 * volume);
    }
}

// At its crossings a wire is its diameter and a little off the surface, in the pattern's rhythm.
TEST_F(WireTubesTest, GoOverTwoAndUnderTwo)
{
    const WireTubes all = tubes(braid());
    const double height = 15e-6 * std::sqrt(pi / 4.0 / std::sin(pi / 4.0)) + 0.75e-6;
    for (const std::vector<Vec3>& line : all.lines) {
        int changes = 0, same = 0;
        double before = 0.0;
        for (std::size_t i = 0; i < line.size(); i += 6) {
            const double z = std::hypot(line[i].x(), line[i].y()) - 2e-3;
            EXPECT_NEAR(std::abs(z), height, 1e-9);
            changes += before * z < 0.0;
            same += before * z > 0.0;
            before = z;
        }
        EXPECT_LE(std::abs(changes - same), 1);
    }
}

// A wire on the wall would stand out of it by its diameter and more; the layer is moved inwards.
TEST_F(WireTubesTest, LieInTheLumenWhereTheDeviceLiesOnTheWall)
{
    const WireTubes all = tubes(braid(2.5e-3));
    double nearest = 1.0;
    for (const Vec3& point : all.mesh.points) {
        ASSERT_TRUE(wall.contains(point));
        nearest = std::min(nearest, wall.nearest(point).distance);
    }
    EXPECT_GT(nearest, 0.5e-6);
    EXPECT_LT(nearest, 3e-6);
    EXPECT_EQ(all.num_overlaps, 0U);
}

// Rings 10 um apart: wires of one family are 20 um apart or less, with a diameter of 30 um.
TEST_F(WireTubesTest, TellOfWiresThatOverlap)
{
    const WireTubes dense = tubes(test::braid_on_cylinder(device, 2e-3, 10e-6, 6e-3));
    EXPECT_GT(dense.num_overlaps, 0U);
    EXPECT_LT(dense.least_gap, 0.0);
    EXPECT_FALSE(find_defects(dense.mesh).intersecting_triangles.empty());
}

// 48 wires, two triangles a facet for each piece and one for each end.
TEST(NumWireTriangles, CountsPiecesAndEnds)
{
    FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const auto rings = static_cast<std::size_t>(lattice.num_rings);
    EXPECT_EQ(num_wire_triangles(lattice, {.pattern = {}, .facets = 12, .pieces_per_arm = 4}),
              48U * (12U * 2U * 4U * (rings - 1U) + 2U * 12U));
}

}  // namespace
}  // namespace braidzone
