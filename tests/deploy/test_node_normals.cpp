#include "core/triangle_mesh.hpp"
#include "deploy/node_normals.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

class NodeNormals : public testing::Test {
protected:
    NodeNormals() { device.nominal_length = 4e-3; }
    FlowDiverter device = test::pipeline_4x20();
};

// On a cylinder they are its radii; at the ends, where the rhombi lie on one side only, the chords
// of 7.5 degrees tilt them by less than that.
TEST_F(NodeNormals, PointFromTheAxisToTheWall)
{
    const Deployment braid = test::braid_on_cylinder(device, 2e-3, 0.1e-3, 8e-3);
    const std::vector<Vec3> normals = node_normals(braid.lattice, braid.nodes);
    ASSERT_EQ(normals.size(), braid.nodes.size());
    for (std::size_t node = 0; node < normals.size(); ++node) {
        const Vec3 radius = Vec3(braid.nodes[node].x(), braid.nodes[node].y(), 0.0).normalized();
        EXPECT_NEAR((normals[node] - radius).norm(), 0.0, 1e-12);
    }
}

// Two triangles a rhombus, outwards; on a cylinder of radius R with n nodes in rings h apart a
// rhombus has the area 2 h R sin(pi / n).
TEST_F(NodeNormals, TrianglesCoverTheRhombi)
{
    const double spacing = 0.1e-3, radius = 2e-3;
    const Deployment braid = test::braid_on_cylinder(device, radius, spacing, 8e-3);
    const TriangleMesh mesh{braid.nodes, rhombus_triangles(braid.lattice)};
    ASSERT_EQ(mesh.triangles.size(), 2U * static_cast<std::size_t>(braid.lattice.num_rhombi()));
    // Each triangle is folded out of the chord's plane by the sag of 7.5 degrees.
    const double sag = radius * (1.0 - std::cos(std::numbers::pi / 24.0));
    const double area = radius * std::sin(std::numbers::pi / 24.0) * std::hypot(spacing, sag);
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Vec3 vector = area_vector(mesh, static_cast<int>(triangle));
        EXPECT_NEAR(vector.norm(), area, 1e-9 * area);
        const Vec3& corner =
            mesh.points[static_cast<std::size_t>(mesh.triangles[triangle].front())];
        EXPECT_GT(vector.dot(Vec3(corner.x(), corner.y(), 0.0)), 0.0);
    }
}

}  // namespace
}  // namespace braidzone
