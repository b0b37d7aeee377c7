#include "deploy/ring_band_matrix.hpp"

#include <cassert>
#include <mutex>

namespace braidzone {

namespace {

constexpr int rings_per_block = 2;  // the reach of the coupling

// OpenBLAS on square blocks, by column: several times as fast as Eigen's own products, which are
// compiled for the oldest processor.
extern "C" {
void openblas_set_num_threads(int count);
int openblas_get_parallel();
void dpotrf_(const char* triangle, const int* size, double* a, const int* stride, int* info);
void dtrsm_(const char* side, const char* triangle, const char* transposed, const char* diagonal,
            const int* rows, const int* columns, const double* factor, const double* a,
            const int* a_stride, double* b, const int* b_stride);
void dsyrk_(const char* triangle, const char* transposed, const int* size, const int* inner,
            const double* factor, const double* a, const int* a_stride, const double* c_factor,
            double* c, const int* c_stride);
}

/// Held while a matrix is solved: OpenBLAS's build without threads has no locks about its work
/// space either, and two callers at once would spoil each other's numbers. Its builds with threads
/// need no turns; they are held to one thread each, as blocks are too small to share and sums must
/// not depend on how they are shared.
std::unique_lock<std::mutex> turn()
{
    static std::mutex one_caller;
    static const bool has_locks = [] {
        openblas_set_num_threads(1);
        return openblas_get_parallel() != 0;
    }();
    return has_locks ? std::unique_lock<std::mutex>() : std::unique_lock(one_caller);
}

/// Replaces the lower triangle by its Cholesky factor; false if the block is not positive definite.
bool factorise(Eigen::MatrixXd& block)
{
    const int size = static_cast<int>(block.rows());
    int info = 0;
    dpotrf_("L", &size, block.data(), &size, &info);
    return info == 0;
}

/// block = block L^-T
void divide_by_transpose(Eigen::MatrixXd& block, const Eigen::MatrixXd& factor)
{
    const int size = static_cast<int>(block.rows());
    const double one = 1.0;
    dtrsm_("R", "L", "T", "N", &size, &size, &one, factor.data(), &size, block.data(), &size);
}

/// target = target - block block^T, in its lower triangle
void subtract_square(const Eigen::MatrixXd& block, Eigen::MatrixXd& target)
{
    const int size = static_cast<int>(block.rows());
    const double one = 1.0, minus_one = -1.0;
    dsyrk_("L", "N", &size, &size, &minus_one, block.data(), &size, &one, target.data(), &size);
}

}  // namespace

RingBandMatrix::RingBandMatrix(int num_rings, int nodes_per_ring)
    : nodes_per_block_(rings_per_block * nodes_per_ring), num_nodes_(num_rings * nodes_per_ring)
{
    const int num_blocks = (num_rings + rings_per_block - 1) / rings_per_block;
    const int size = 3 * nodes_per_block_;
    diagonal_.assign(static_cast<std::size_t>(num_blocks), Eigen::MatrixXd(size, size));
    below_.assign(static_cast<std::size_t>(num_blocks - 1), Eigen::MatrixXd(size, size));
    set_zero();
}

void RingBandMatrix::set_zero()
{
    for (Eigen::MatrixXd& block : diagonal_)
        block.setZero();
    for (Eigen::MatrixXd& block : below_)
        block.setZero();
    // Rows beyond the last node, if the number of rings is odd, stand for themselves.
    for (int row = row_of(num_nodes_);
         num_nodes_ % nodes_per_block_ != 0 && row < 3 * nodes_per_block_; ++row) {
        diagonal_.back()(row, row) = 1.0;
    }
}

void RingBandMatrix::add(int first, int second, const Eigen::Matrix3d& block)
{
    if (first < second) {
        add(second, first, block.transpose());
        return;
    }
    const int row_block = block_of(first), column_block = block_of(second);
    assert(row_block - column_block <= 1);
    if (row_block == column_block) {
        diagonal_[static_cast<std::size_t>(row_block)].block<3, 3>(row_of(first), row_of(second)) +=
            block;
    } else {
        below_[static_cast<std::size_t>(column_block)].block<3, 3>(row_of(first), row_of(second)) +=
            block;
    }
}

bool RingBandMatrix::solve(std::vector<Vec3>& right_side)
{
    const auto held = turn();
    const int size = 3 * nodes_per_block_;
    const std::size_t num_blocks = diagonal_.size();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(num_blocks) * size);
    x.head(3 * num_nodes_) =
        Eigen::Map<const Eigen::VectorXd>(right_side.front().data(), 3 * num_nodes_);
    const auto part = [&](std::size_t block) {
        return x.segment(static_cast<Eigen::Index>(block) * size, size);
    };

    // A = L L^T, with L_ii in the diagonal blocks and L_(i+1)i = A_(i+1)i L_ii^-T below them.
    for (std::size_t i = 0; i < num_blocks; ++i) {
        if (i > 0) {
            subtract_square(below_[i - 1], diagonal_[i]);
            part(i).noalias() -= below_[i - 1] * part(i - 1);
        }
        if (!factorise(diagonal_[i])) return false;
        part(i) = diagonal_[i].triangularView<Eigen::Lower>().solve(part(i));
        if (i + 1 < num_blocks) divide_by_transpose(below_[i], diagonal_[i]);
    }
    for (std::size_t i = num_blocks; i-- > 0;) {
        if (i + 1 < num_blocks) part(i).noalias() -= below_[i].transpose() * part(i + 1);
        part(i) = diagonal_[i].triangularView<Eigen::Lower>().transpose().solve(part(i));
    }
    Eigen::Map<Eigen::VectorXd>(right_side.front().data(), 3 * num_nodes_) = x.head(3 * num_nodes_);
    return true;
}

}  // namespace braidzone
