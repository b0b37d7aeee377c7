#include "export/device_shell.hpp"

#include "core/mesh_topology.hpp"
#include "deploy/node_normals.hpp"
#include "export/braid_inset.hpp"

namespace braidzone {

TriangleMesh make_device_shell(const Deployment& deployment, double thickness, const WallTree& wall,
                               double wall_gap)
{
    const std::vector<Vec3> normals = node_normals(deployment.lattice, deployment.nodes);
    TriangleMesh outside{{}, rhombus_triangles(deployment.lattice)};
    std::vector<Vec3> inner_points;
    for (std::size_t node = 0; node < normals.size(); ++node) {
        const Vec3 middle =
            off_the_wall(deployment.nodes[node], normals[node], wall, 0.5 * thickness + wall_gap);
        outside.points.push_back(middle + 0.5 * thickness * normals[node]);
        inner_points.push_back(middle - 0.5 * thickness * normals[node]);
    }
    TriangleMesh shell = outside;
    shell.points.insert(shell.points.end(), inner_points.begin(), inner_points.end());
    const int num_nodes = static_cast<int>(outside.points.size());
    for (const auto& [a, b, c] : outside.triangles)
        shell.triangles.push_back({a + num_nodes, c + num_nodes, b + num_nodes});
    for (const std::vector<int>& rim : border_loops(outside)) {
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const int from = rim[i], to = rim[(i + 1) % rim.size()];
            shell.triangles.push_back({from, to, to + num_nodes});
            shell.triangles.push_back({from, to + num_nodes, from + num_nodes});
        }
    }
    return shell;
}

}  // namespace braidzone
