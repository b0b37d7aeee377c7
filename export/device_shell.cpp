#include "export/device_shell.hpp"

#include "core/mesh_topology.hpp"

namespace braidzone {

TriangleMesh make_device_shell(const BraidLattice& lattice, const InsetBraid& braid,
                               double thickness)
{
    const TriangleMesh outside = inner_face(lattice, braid, -0.5 * thickness);
    const TriangleMesh inside = inner_face(lattice, braid, 0.5 * thickness);
    TriangleMesh shell = outside;
    shell.points.insert(shell.points.end(), inside.points.begin(), inside.points.end());
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
