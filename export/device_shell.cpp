#include "export/device_shell.hpp"

#include "core/mesh_topology.hpp"
#include "deploy/node_normals.hpp"
#include "export/braid_inset.hpp"

namespace braidzone {

TriangleMesh make_device_shell(const Deployment& deployment, double thickness, const WallTree& wall,
                               double wall_gap)
{
    const InsetBraid braid = inset_braid(deployment, wall, 0.5 * thickness + wall_gap);
    TriangleMesh outside{braid.nodes, rhombus_triangles(deployment.lattice)};
    std::vector<Vec3> inner_points = braid.nodes;
    for (std::size_t node = 0; node < inner_points.size(); ++node) {
        outside.points[node] += 0.5 * thickness * braid.normals[node];
        inner_points[node] -= 0.5 * thickness * braid.normals[node];
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
