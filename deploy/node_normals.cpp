#include "deploy/node_normals.hpp"

namespace braidzone {

namespace {

/// Calls visit(corners) for each rhombus of a lattice, in order.
template <typename Visit>
void for_each_rhombus(const BraidLattice& lattice, Visit visit)
{
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring)
        for (int column = 0; column < lattice.nodes_per_ring; ++column)
            visit(rhombus_corners(lattice, ring, column));
}

}  // namespace

std::vector<Vec3> node_normals(const BraidLattice& lattice, const std::vector<Vec3>& nodes)
{
    const auto node = [&](int index) -> const Vec3& {
        return nodes[static_cast<std::size_t>(index)];
    };
    std::vector<Vec3> normals(nodes.size(), Vec3::Zero());
    for_each_rhombus(lattice, [&](const std::array<int, 4>& corners) {
        const auto& [a, b, c, d] = corners;
        const Vec3 area = (node(c) - node(a)).cross(node(d) - node(b));
        for (const int corner : corners)
            normals[static_cast<std::size_t>(corner)] += area;
    });
    for (Vec3& normal : normals)
        normal.normalize();
    return normals;
}

std::vector<std::array<int, 3>> rhombus_triangles(const BraidLattice& lattice)
{
    std::vector<std::array<int, 3>> triangles;
    for_each_rhombus(lattice, [&](const std::array<int, 4>& corners) {
        const auto& [a, b, c, d] = corners;
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
    });
    return triangles;
}

}  // namespace braidzone
