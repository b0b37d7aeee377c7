#include "deploy/device_lining.hpp"

#include "deploy/node_normals.hpp"

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
    const std::vector<Vec3> normals = node_normals(deployment.lattice, deployment.nodes);
    TriangleMesh mesh{deployment.nodes, rhombus_triangles(deployment.lattice)};
    for (std::size_t node = 0; node < normals.size(); ++node)
        mesh.points[node] -= 2.0 * wire_diameter * normals[node];
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
