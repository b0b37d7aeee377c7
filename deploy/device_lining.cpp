#include "deploy/device_lining.hpp"

namespace braidzone {

namespace {

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// The rhombus of number i of a lattice, see `rhombus_corners`.
std::array<int, 4> corners_of_rhombus(const BraidLattice& lattice, int rhombus)
{
    return rhombus_corners(lattice, rhombus / lattice.nodes_per_ring,
                           rhombus % lattice.nodes_per_ring);
}

}  // namespace

TriangleMesh inner_surface(const Deployment& deployment, double wire_diameter)
{
    const BraidLattice& lattice = deployment.lattice;
    const std::vector<Vec3>& nodes = deployment.nodes;
    TriangleMesh mesh;
    std::vector<Vec3> normals(nodes.size(), Vec3::Zero());
    for (int rhombus = 0; rhombus < lattice.num_rhombi(); ++rhombus) {
        const std::array<int, 4> corners = corners_of_rhombus(lattice, rhombus);
        const auto& [a, b, c, d] = corners;
        // Cut between the two nodes of one ring, the shorter diagonal of a braid that lies well.
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
        const Vec3 area =
            (nodes[index(c)] - nodes[index(a)]).cross(nodes[index(d)] - nodes[index(b)]);
        for (const int corner : corners)
            normals[index(corner)] += area;
    }
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        mesh.points.push_back(nodes[node] - 2.0 * wire_diameter * normals[node].normalized());
    }
    return mesh;
}

void measure_wall_distance_through(Deployment& second, const Deployment& first,
                                   const WallTree& lined_wall, int num_wall_triangles)
{
    for (std::size_t node = 0; node < second.nodes.size(); ++node) {
        const WallPoint nearest = lined_wall.nearest(second.nodes[node]);
        if (nearest.triangle < num_wall_triangles) continue;
        const int rhombus = (nearest.triangle - num_wall_triangles) / 2;
        double through = 0.0;
        for (const int corner : corners_of_rhombus(first.lattice, rhombus))
            through += 0.25 * first.wall_distance[index(corner)];
        second.wall_distance[node] = nearest.distance + through;
    }
}

}  // namespace braidzone
