#pragma once

#include "core/vector.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// A symmetric positive definite matrix over the coordinates of a stretch of rings, in which a ring
/// is coupled to its neighbours and their neighbours only.
///
/// Two rings together form a block of 6 n rows, so that the matrix is block tridiagonal. Cost of a
/// solution is linear in the rings and cubic in the nodes of a ring. Arithmetic is in a fixed order
/// on one thread.
class RingBandMatrix {
public:
    /// @param num_rings       of the stretch; >= 1
    /// @param nodes_per_ring  n; >= 1
    RingBandMatrix(int num_rings, int nodes_per_ring);

    int num_rings() const { return num_nodes_ * 2 / nodes_per_block_; }

    void set_zero();

    /// Adds to the 3 x 3 block of two nodes, and to its mirror image if the nodes differ. Nodes
    /// count from the stretch's first ring; their rings differ by two at most.
    void add(int first, int second, const Eigen::Matrix3d& block);

    /// Solves A x = b by block Cholesky factorisation, which overwrites the matrix.
    /// @param right_side  b, one vector a node; overwritten by x
    /// @return false if the matrix is not positive definite
    bool solve(std::vector<Vec3>& right_side);

private:
    int block_of(int node) const { return node / nodes_per_block_; }
    int row_of(int node) const { return 3 * (node % nodes_per_block_); }

    int nodes_per_block_;
    int num_nodes_;
    std::vector<Eigen::MatrixXd> diagonal_;  ///< lower triangles count
    std::vector<Eigen::MatrixXd> below_;     ///< block (i + 1, i)
};

}  // namespace braidzone
