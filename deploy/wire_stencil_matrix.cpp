#include "deploy/wire_stencil_matrix.hpp"

#include <algorithm>
#include <utility>

namespace braidzone {

WireStencilMatrix::WireStencilMatrix(const BraidLattice& lattice)
{
    const auto step_from = [&](int node, int step) {
        const int ring = node / lattice.nodes_per_ring;
        if (node < 0 || ring + 1 >= lattice.num_rings) return -1;
        return lattice.node(ring + 1, node % lattice.nodes_per_ring + step);
    };
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        const auto& [right, left] = lattice.arm_steps;
        const int next_right = step_from(node, right), next_left = step_from(node, left);
        nodes_.push_back({node, next_right, next_left, step_from(next_right, right),
                          step_from(next_left, left)});
    }
    set_zero();
}

void WireStencilMatrix::set_zero()
{
    stencils_.assign(nodes_.size(), Stencil{});
}

Eigen::SparseMatrix<double> WireStencilMatrix::lower_triangle(const std::vector<int>& places,
                                                              int size) const
{
    Eigen::SparseMatrix<double> lower(size, size);
    lower.reserve(5 * static_cast<Eigen::Index>(size));
    for (std::size_t node = 0; node < stencils_.size(); ++node) {
        const int column = places[node];
        if (column < 0) continue;
        std::array<std::pair<int, double>, 5> entries;
        std::size_t count = 0;
        for (std::size_t i = 0; i < 5; ++i) {
            const int other = nodes_[node][i];
            const int row = other < 0 ? -1 : places[static_cast<std::size_t>(other)];
            if (row >= 0) entries[count++] = {row, stencils_[node][i]};
        }
        std::sort(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(count));
        lower.startVec(column);
        for (std::size_t i = 0; i < count;) {
            const int row = entries[i].first;
            double sum = 0.0;  // on a ring of few nodes both wires may meet the same one
            for (; i < count && entries[i].first == row; ++i)
                sum += entries[i].second;
            lower.insertBack(row, column) = sum;
        }
    }
    lower.finalize();
    return lower;
}

}  // namespace braidzone
