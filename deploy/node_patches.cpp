#include "deploy/node_patches.hpp"

#include <algorithm>
#include <numeric>

namespace braidzone {

namespace {

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

}  // namespace

std::vector<int> connected_patches(const BraidLattice& lattice, const std::vector<char>& flagged)
{
    std::vector<int> parent(flagged.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int node) {
        while (parent[index(node)] != node)
            node = parent[index(node)];
        return node;
    };
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            int lowest = -1;
            for (const int corner : rhombus_corners(lattice, ring, column)) {
                if (!flagged[index(corner)]) continue;
                const int own = root(corner);
                if (lowest < 0) lowest = own;
                parent[index(std::max(own, lowest))] = std::min(own, lowest);
                lowest = std::min(own, lowest);
            }
        }
    }
    std::vector<int> patch(flagged.size(), -1);
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        if (flagged[index(node)]) patch[index(node)] = root(node);
    }
    return patch;
}

}  // namespace braidzone
