#include "core/mesh_topology.hpp"
#include "core/surface_check.hpp"
#include "export/device_shell.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace braidzone {
namespace {

class DeviceShell : public testing::Test {
protected:
    DeviceShell() { device.nominal_length = 4e-3; }

    TriangleMesh shell_of(const Deployment& braid, double thickness, const WallTree& tree) const
    {
        const InsetBraid inset = inset_braid(braid, tree, 0.5 * thickness + 1.5e-6);
        return make_device_shell(braid.lattice, inset, thickness);
    }

    FlowDiverter device = test::pipeline_4x20();
    Vessel vessel = test::tube_vessel(2e-3, 10e-3, 192);
    WallTree wall{vessel};
};

TEST_F(DeviceShell, IsOneClosedSolidByCgal)
{
    const Deployment braid = test::braid_on_cylinder(device, 1.7e-3, 0.1e-3, 8e-3);
    const TriangleMesh shell = shell_of(braid, 60e-6, wall);
    EXPECT_TRUE(border_loops(shell).empty());
    EXPECT_TRUE(is_sound(find_defects(shell))) << describe(find_defects(shell));
}

// (Outer prism less inner) times the height: with n = 24 nodes a ring the triangles lie between the
// polygons of n and 2 n corners; the mean of both is within 0.3 % of either. The zigzag of the rims
// takes half a ring's spacing off each end: N - 1 gaps less one.
TEST_F(DeviceShell, HoldsAreaTimesThickness)
{
    constexpr double radius = 1.7e-3, thickness = 60e-6, spacing = 0.1e-3;
    const Deployment braid = test::braid_on_cylinder(device, radius, spacing, 8e-3);
    const double height = spacing * (braid.lattice.num_rings - 2);
    const double volume = 2.0 * std::numbers::pi * radius * thickness * height;
    const TriangleMesh shell = shell_of(braid, thickness, wall);
    EXPECT_NEAR(enclosed_volume(shell), volume, 0.01 * volume);
}

TEST_F(DeviceShell, LiesBesideTheWallAndDoesNotCutIt)
{
    const Deployment braid = test::braid_on_cylinder(device, 2e-3, 0.1e-3, 8e-3);
    const TriangleMesh shell = shell_of(braid, 60e-6, wall);
    for (const Vec3& point : shell.points) {
        ASSERT_TRUE(wall.contains(point));
        EXPECT_GT(wall.nearest(point).distance, 0.5e-6);
    }
}

// Thicker than the device is wide: the inner side turns inside out, which the check tells.
TEST_F(DeviceShell, OfAbsurdThicknessCrossesItself)
{
    const WallTree wide(test::tube_vessel(9e-3, 20e-3));
    const Deployment braid = test::braid_on_cylinder(device, 2e-3, 0.1e-3, 8e-3);
    EXPECT_FALSE(is_sound(find_defects(shell_of(braid, 5e-3, wide))));
}

}  // namespace
}  // namespace braidzone
