#include "deploy/deployment.hpp"
#include "deploy/deployment_measures.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

constexpr double length = 10e-3;

FlowDiverter coarse_device()
{
    FlowDiverter device = test::pipeline_4x20();
    device.num_wires = 24;
    device.nominal_length = 5e-3;
    device.youngs_modulus = 200e9;
    return device;
}

Deployment deploy_in_planes(const Vessel& vessel, double friction = infinite_friction)
{
    DeployOptions options;
    options.hoop_migration = true;
    options.friction = friction;
    return deploy(coarse_device(), test::tube_centerline(1.7e-3, length), WallTree(vessel), 8e-3,
                  {}, options);
}

/// A tube of 1.7 mm whose side x > 0 is drawn out to 2.8 mm around the middle.
Vessel bulging_vessel()
{
    TriangleMesh mesh = test::tube(1.7e-3, length, 64, 80);
    for (Vec3& point : mesh.points) {
        const double angle = std::atan2(point.y(), point.x());
        const double along = std::exp(-std::pow((point.z() - 0.5 * length) / 1.2e-3, 2));
        const double around = std::pow(std::max(0.0, std::cos(angle)), 2);
        point.head<2>() *= 1.0 + (2.8 / 1.7 - 1.0) * along * around;
    }
    return make_vessel(mesh, LengthUnit{"mm", 1e-3});
}

}  // namespace

// A round wall holds every node where its ray meets it: the shape is that of nodes on rays.
TEST(PlaneRelease, AgreesWithNodesOnRaysInARoundTube)
{
    const Vessel vessel = test::tube_vessel(1.7e-3, length);
    const Deployment on_rays =
        deploy(coarse_device(), test::tube_centerline(1.7e-3, length), WallTree(vessel), 8e-3, {});
    const Deployment in_planes = deploy_in_planes(vessel);
    ASSERT_TRUE(in_planes.converged);
    // Nodes slide around the ring until they have settled, by a few micrometres.
    for (std::size_t i = 0; i < on_rays.nodes.size(); ++i)
        EXPECT_LT((on_rays.nodes[i] - in_planes.nodes[i]).norm(), 10e-6) << i;
    const auto sum = [](const std::vector<double>& forces) {
        double total = 0.0;
        for (double force : forces)
            total += force;
        return total;
    };
    EXPECT_NEAR(sum(in_planes.contact_force) / sum(on_rays.contact_force), 1.0, 0.01);
}

TEST(PlaneRelease, KeepsNodesInThePlanesOfTheirRings)
{
    const Deployment deployment = deploy_in_planes(bulging_vessel());
    const int n = deployment.lattice.nodes_per_ring;
    for (int node = 0; node < deployment.lattice.num_nodes(); ++node) {
        const CrossSection& ring = deployment.rings[static_cast<std::size_t>(node / n)];
        const Vec3 from_hub = deployment.nodes[static_cast<std::size_t>(node)] - ring.origin;
        EXPECT_LT(std::abs(ring.tangent.dot(from_hub)), 1e-9);
    }
}

// Over the bulge nothing holds the nodes; they draw braid from beside it and stand further apart
// than where the wall holds them at the angles at which they were released.
TEST(PlaneRelease, LetsNodesMigrateIntoABulge)
{
    const Deployment deployment = deploy_in_planes(bulging_vessel());
    ASSERT_TRUE(deployment.converged);
    EXPECT_TRUE(inverted_rhombi(deployment).empty());
    double furthest = 0.0, largest_turn = 0.0;
    const BraidLattice& lattice = deployment.lattice;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const CrossSection& section = deployment.rings[static_cast<std::size_t>(ring)];
            const Vec3 from_hub =
                deployment.nodes[static_cast<std::size_t>(lattice.node(ring, column))] -
                section.origin;
            const double angle =
                std::atan2(from_hub.dot(section.binormal), from_hub.dot(section.normal));
            largest_turn =
                std::max(largest_turn, std::abs(std::remainder(angle - lattice.angle(ring, column),
                                                               2.0 * std::numbers::pi)));
            furthest = std::max(furthest, from_hub.norm());
        }
    }
    EXPECT_GT(furthest, 1.9e-3);
    EXPECT_GT(largest_turn, 0.01);  // 20 um along the ring
    EXPECT_LT(largest_turn, lattice.angle(0, 1));
}

TEST(PlaneRelease, LetsNodesSlideFurtherWithLessFriction)
{
    const Vessel vessel = bulging_vessel();
    const auto furthest = [&](double friction) {
        const Deployment deployment = deploy_in_planes(vessel, friction);
        EXPECT_TRUE(deployment.converged) << friction;
        double x = 0.0;
        for (const Vec3& node : deployment.nodes)
            x = std::max(x, node.x());
        return x;
    };
    EXPECT_GE(furthest(0.0), furthest(infinite_friction) - 1e-6);
}

}  // namespace braidzone
