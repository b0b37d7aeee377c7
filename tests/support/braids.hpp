#pragma once

#include "deploy/deployment.hpp"
#include "porous/braid_surface.hpp"
#include "porous/deposit_kernel.hpp"

#include <cmath>
#include <vector>

namespace braidzone::test {

/// A device that lies as a uniform braid on a cylinder about z with the given radius and ring
/// spacing, its distal end at z = `distal` and the others below; free of the wall by
/// `wall_distance`. Right-handed wires are right-handed helices.
inline Deployment braid_on_cylinder(const FlowDiverter& device, double radius, double ring_spacing,
                                    double distal, double wall_distance = 1e-3)
{
    Deployment deployment;
    deployment.lattice = make_lattice(device);
    const BraidLattice& lattice = deployment.lattice;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const double z = distal - ring * ring_spacing;
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const double angle = lattice.angle(ring, column);
            deployment.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
        CrossSection section;
        section.origin = Vec3(0, 0, z);
        section.tangent = Vec3::UnitZ();
        section.normal = Vec3::UnitX();
        section.binormal = Vec3::UnitY();
        section.inscribed_radius = radius + wall_distance;
        deployment.rings.push_back(section);
        deployment.ring_arc_length.push_back(z);
    }
    const auto num_nodes = static_cast<std::size_t>(lattice.num_nodes());
    deployment.in_contact.assign(num_nodes, 0);
    deployment.wall_distance.assign(num_nodes, wall_distance);
    deployment.contact_force.assign(num_nodes, 0.0);
    deployment.contact_pressure.assign(num_nodes, 0.0);
    deployment.converged = true;
    return deployment;
}

/// A flat sheet of count_a x count_b equal braid cells with edges `edge_a` and `edge_b`, one corner
/// at `origin`, normals along edge_a x edge_b.
inline BraidSurface flat_braid(const Vec3& origin, const Vec3& edge_a, int count_a,
                               const Vec3& edge_b, int count_b, double wire_diameter)
{
    std::vector<Vec3> points;
    for (int j = 0; j <= count_b; ++j) {
        for (int i = 0; i <= count_a; ++i) {
            points.push_back(origin + i * edge_a + j * edge_b);
        }
    }
    std::vector<std::array<int, 4>> corners;
    for (int j = 0; j < count_b; ++j) {
        for (int i = 0; i < count_a; ++i) {
            const int first = j * (count_a + 1) + i;
            corners.push_back({first, first + 1, first + count_a + 2, first + count_a + 1});
        }
    }
    return make_braid_surface(points, corners, wire_diameter, edge_a.cross(edge_b).norm());
}

/// The pieces of all rhombi, in their order.
inline std::vector<SheetPiece> pieces_of(const BraidSurface& surface, double longest_edge)
{
    std::vector<SheetPiece> all;
    for (std::size_t rhombus = 0; rhombus < surface.rhombi.size(); ++rhombus) {
        const std::vector<SheetPiece> pieces = cut_into_pieces(surface, rhombus, longest_edge);
        all.insert(all.end(), pieces.begin(), pieces.end());
    }
    return all;
}

}  // namespace braidzone::test
