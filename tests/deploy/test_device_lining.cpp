#include "deploy/device_lining.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace braidzone {
namespace {

constexpr double vessel_radius = 2e-3, vessel_length = 16e-3;
constexpr double first_radius = 1.8e-3;
constexpr double wire_diameter = 30e-6;

/// A device of 4 mm length on a cylinder about the vessel's axis.
Deployment device_at(double radius, double distal, double wall_distance)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 4e-3;
    return test::braid_on_cylinder(device, radius, make_lattice(device).ring_spacing, distal,
                                   wall_distance);
}

Vec3 radial(const Vec3& point)
{
    return Vec3(point.x(), point.y(), 0.0).normalized();
}

/// A first device at 1.8 mm, a second one at 1.5 mm that reaches 2 mm further, and the lined wall.
struct TwoDevices {
    Vessel vessel = test::tube_vessel(vessel_radius, vessel_length);
    Deployment first = device_at(first_radius, 10e-3, 0.0);
    Deployment second = device_at(1.5e-3, 12e-3, 0.5e-3);
    WallTree lined_wall{vessel, inner_surface(first, wire_diameter)};
    int num_wall_triangles = static_cast<int>(vessel.wall.triangles.size());
};

}  // namespace

TEST(InnerSurface, HasTwoTrianglesForEachRhombus)
{
    const Deployment device = device_at(first_radius, 10e-3, 0.0);
    const TriangleMesh lining = inner_surface(device, wire_diameter);
    ASSERT_EQ(lining.points.size(), device.nodes.size());
    const BraidLattice& lattice = device.lattice;
    ASSERT_EQ(lining.triangles.size(), 2 * static_cast<std::size_t>(lattice.num_rhombi()));
    for (int rhombus = 0; rhombus < lattice.num_rhombi(); ++rhombus) {
        const auto corners = rhombus_corners(lattice, rhombus / lattice.nodes_per_ring,
                                             rhombus % lattice.nodes_per_ring);
        std::set<int> covered;
        for (int half = 0; half < 2; ++half) {
            const auto& triangle = lining.triangles[static_cast<std::size_t>(2 * rhombus + half)];
            covered.insert(triangle.begin(), triangle.end());
        }
        EXPECT_EQ(covered, std::set<int>(corners.begin(), corners.end())) << rhombus;
    }
}

// On a circular cylinder the rhombi around a node are mirror images of each other, so that the
// offset is along the radius: 1.8 mm - 2 x 30 um = 1.74 mm, at the same angle and place.
TEST(InnerSurface, LiesTwoWiresInsideTheCrossings)
{
    const Deployment device = device_at(first_radius, 10e-3, 0.0);
    const TriangleMesh lining = inner_surface(device, wire_diameter);
    for (std::size_t node = 0; node < device.nodes.size(); ++node) {
        const Vec3 expected = device.nodes[node] - 60e-6 * radial(device.nodes[node]);
        EXPECT_NEAR((lining.points[node] - expected).norm(), 0.0, 1e-12) << node;
    }
}

TEST(InnerSurface, HasNormalsToTheWall)
{
    const TriangleMesh lining = inner_surface(device_at(first_radius, 10e-3, 0.0), wire_diameter);
    const auto at = [&](int point) { return lining.points[static_cast<std::size_t>(point)]; };
    for (const auto& [a, b, c] : lining.triangles) {
        const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
        EXPECT_GT(normal.normalized().dot(radial((at(a) + at(b) + at(c)) / 3.0)), 0.99);
    }
}

// The lining's facets lie between 1.74 mm and 1.74 cos(pi / 24) mm, a node of the second device at
// 1.5 mm: 0.240 to 0.225 mm. Through the first device the wall is 0.1 mm further.
TEST(MeasureWallDistanceThrough, AddsThatOfTheFirstDevice)
{
    TwoDevices devices;
    devices.first.wall_distance.assign(devices.first.nodes.size(), 0.1e-3);
    const std::vector<double> before = devices.second.wall_distance;
    measure_wall_distance_through(devices.second, devices.first, devices.lined_wall,
                                  devices.num_wall_triangles);
    const double lining = first_radius - 2.0 * wire_diameter;
    const double nearest = lining * std::cos(std::numbers::pi / 24) - 1.5e-3;
    int through = 0;
    for (std::size_t node = 0; node < devices.second.nodes.size(); ++node) {
        const double z = devices.second.nodes[node].z();
        if (z < devices.first.nodes.front().z() - 0.2e-3) {  // well within the first device
            EXPECT_GE(devices.second.wall_distance[node], nearest + 0.1e-3 - 1e-9);
            EXPECT_LE(devices.second.wall_distance[node], lining - 1.5e-3 + 0.1e-3 + 1e-9);
            ++through;
        } else if (z > devices.first.nodes.front().z() + 1e-3) {  // nearer to the vessel's wall
            EXPECT_EQ(devices.second.wall_distance[node], before[node]);
        }
    }
    EXPECT_GT(through, 100);
}

// The first device is free of the wall over the half with x > 0 alone.
TEST(MeasureWallDistanceThrough, TakesTheFirstDeviceWhereTheSecondLies)
{
    TwoDevices devices;
    for (std::size_t node = 0; node < devices.first.nodes.size(); ++node)
        devices.first.wall_distance[node] = devices.first.nodes[node].x() > 0.0 ? 2e-3 : 0.0;
    measure_wall_distance_through(devices.second, devices.first, devices.lined_wall,
                                  devices.num_wall_triangles);
    for (std::size_t node = 0; node < devices.second.nodes.size(); ++node) {
        const Vec3& point = devices.second.nodes[node];
        if (point.z() > devices.first.nodes.front().z() - 0.2e-3) continue;
        if (point.x() > 0.6e-3) {
            EXPECT_GT(devices.second.wall_distance[node], 2e-3);
        } else if (point.x() < -0.6e-3) {
            EXPECT_LT(devices.second.wall_distance[node], 0.25e-3);
        }
    }
}

TEST(MeasureWallDistanceThrough, IsThatToTheLiningWhereTheFirstDeviceLiesOnTheWall)
{
    TwoDevices devices;
    measure_wall_distance_through(devices.second, devices.first, devices.lined_wall,
                                  devices.num_wall_triangles);
    const std::size_t node = devices.second.nodes.size() - 1;
    EXPECT_DOUBLE_EQ(devices.second.wall_distance[node],
                     devices.lined_wall.nearest(devices.second.nodes[node]).distance);
}

}  // namespace braidzone
