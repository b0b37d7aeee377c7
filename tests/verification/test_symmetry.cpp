// A vessel that is turned, moved or mirrored gives a deployment that is turned, moved or mirrored.

#include "deploy/deployment.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

constexpr double length = 14e-3;

/// A tube that widens to one side, off its symmetry planes.
TriangleMesh lopsided_tube()
{
    TriangleMesh mesh = test::tube(1.75e-3, length, 96, 96);
    for (Vec3& point : mesh.points) {
        const double angle = std::atan2(point.y(), point.x());
        const double along = std::exp(-std::pow((point.z() - 0.45 * length) / 1.2e-3, 2));
        point.head<2>() *= 1.0 + 0.4 * along * std::pow(std::max(0.0, std::cos(angle - 0.4)), 2);
    }
    return mesh;
}

Deployment deploy_in(TriangleMesh mesh, const Eigen::Matrix3d& turn, const Vec3& shift)
{
    for (Vec3& point : mesh.points)
        point = turn * point + shift;
    if (turn.determinant() < 0.0) {
        for (auto& [a, b, c] : mesh.triangles)
            std::swap(b, c);
    }
    Centerline axis = test::tube_centerline(1.75e-3, length);
    for (CrossSection& section : axis.sections) {
        section.origin = turn * section.origin + shift;
        section.tangent = turn * section.tangent;
        section.normal = turn * section.normal;
        section.binormal = section.tangent.cross(section.normal);
    }
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 8e-3;
    const Vessel vessel = make_vessel(mesh, LengthUnit{"mm", 1e-3});
    return deploy(device, axis, WallTree(vessel), 11e-3, {});
}

}  // namespace

// What is left are rounding and the tolerance at which the motion ends, 0.2 um.
TEST(Symmetry, TurnsAndMovesWithTheVessel)
{
    const Deployment still = deploy_in(lopsided_tube(), Eigen::Matrix3d::Identity(), Vec3::Zero());
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const Vec3 shift(3e-3, -7e-3, 1e-3);
    const Deployment turned = deploy_in(lopsided_tube(), turn, shift);
    ASSERT_EQ(turned.nodes.size(), still.nodes.size());
    for (std::size_t i = 0; i < still.nodes.size(); ++i)
        EXPECT_LT((turned.nodes[i] - (turn * still.nodes[i] + shift)).norm(), 1e-8) << i;
}

// In the mirror the right-handed wires are left-handed. Node (k, j) at the angle (j + k/2) 2 pi / n
// about the mirrored axis has its image at minus that angle: column -j - k.
TEST(Symmetry, MirrorsWithTheVessel)
{
    const Deployment still = deploy_in(lopsided_tube(), Eigen::Matrix3d::Identity(), Vec3::Zero());
    const Eigen::Matrix3d mirror = Vec3(1, -1, 1).asDiagonal();
    const Deployment mirrored = deploy_in(lopsided_tube(), mirror, Vec3::Zero());
    const int n = still.lattice.nodes_per_ring;
    double force = 0.0;
    for (int ring = 0; ring < still.lattice.num_rings; ++ring) {
        for (int column = 0; column < n; ++column) {
            const int image = ((-column - ring) % n + n) % n;
            const auto i = static_cast<std::size_t>(still.lattice.node(ring, column));
            const auto j = static_cast<std::size_t>(still.lattice.node(ring, image));
            EXPECT_LT((mirrored.nodes[j] - mirror * still.nodes[i]).norm(), 1e-8);
            EXPECT_NEAR(mirrored.contact_force[j], still.contact_force[i], 1e-9);
            force += still.contact_force[i];
        }
    }
    EXPECT_GT(force, 1e-3);
}

}  // namespace braidzone
