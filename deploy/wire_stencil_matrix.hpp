#pragma once

#include "deploy/braid_lattice.hpp"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace braidzone {

/// A symmetric matrix over the nodes of a braid, one row a node, in which a node is coupled along
/// both of its wires to the next node and to the one after it.
class WireStencilMatrix {
public:
    explicit WireStencilMatrix(const BraidLattice& lattice);

    void set_zero();

    /// Adds to the diagonal.
    void add_own(int node, double value) { at(node)[0] += value; }
    /// Adds to the coupling with the node that follows proximally along a wire, and to its mirror
    /// image.
    /// @param family  0 or 1, see `BraidLattice::arm_steps`; the node is not of the last ring
    void add_next(int node, std::size_t family, double value) { at(node)[1 + family] += value; }
    /// The same for the node after that; the node is not of the last two rings.
    void add_second(int node, std::size_t family, double value) { at(node)[3 + family] += value; }

    /// Rows and columns of some nodes: the lower triangle.
    /// @param places  |N| row of each node, -1 for those left out; growing with the node
    /// @param size    number of the others
    Eigen::SparseMatrix<double> lower_triangle(const std::vector<int>& places, int size) const;

private:
    /// The node itself, next, next, second, second.
    using Stencil = std::array<double, 5>;
    Stencil& at(int node) { return stencils_[static_cast<std::size_t>(node)]; }

    std::vector<Stencil> stencils_;
    std::vector<std::array<int, 5>> nodes_;  ///< those of the stencils, -1 beyond the end
};

}  // namespace braidzone
