#include "deploy/ring_band_matrix.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <thread>

namespace braidzone {

namespace {

/// A random symmetric, diagonally dominant matrix with the coupling that the band allows, both as a
/// band and as a full matrix.
struct Sample {
    RingBandMatrix band;
    Eigen::MatrixXd full;
    std::vector<Vec3> right_side;
};

Sample random_sample(int num_rings, int nodes_per_ring)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const int num_nodes = num_rings * nodes_per_ring;
    Sample sample{RingBandMatrix(num_rings, nodes_per_ring),
                  Eigen::MatrixXd::Zero(3 * num_nodes, 3 * num_nodes),
                  {}};
    const auto random_block = [&] {
        return Eigen::Matrix3d::NullaryExpr([&] { return number(random); }).eval();
    };
    for (int first = 0; first < num_nodes; ++first) {
        const Eigen::Matrix3d square = random_block();
        const Eigen::Matrix3d diagonal =
            square * square.transpose() + 20.0 * nodes_per_ring * Eigen::Matrix3d::Identity();
        sample.band.add(first, first, diagonal);
        sample.full.block<3, 3>(3 * first, 3 * first) += diagonal;
        for (int second = 0; second < first; ++second) {
            if (first / nodes_per_ring - second / nodes_per_ring > 2) continue;
            const Eigen::Matrix3d block = random_block();
            // Either order must give the same matrix.
            if ((first + second) % 2 == 0) {
                sample.band.add(first, second, block);
            } else {
                sample.band.add(second, first, block.transpose());
            }
            sample.full.block<3, 3>(3 * first, 3 * second) += block;
            sample.full.block<3, 3>(3 * second, 3 * first) += block.transpose();
        }
        sample.right_side.emplace_back(number(random), number(random), number(random));
    }
    return sample;
}

}  // namespace

// Against a dense solution by another decomposition; even and odd numbers of rings.
TEST(RingBandMatrix, SolvesAsADenseMatrixDoes)
{
    for (int num_rings : {1, 2, 5, 6}) {
        Sample sample = random_sample(num_rings, 4);
        const auto size = static_cast<Eigen::Index>(3 * sample.right_side.size());
        const Eigen::VectorXd b =
            Eigen::Map<const Eigen::VectorXd>(sample.right_side.front().data(), size);
        const Eigen::VectorXd expected = sample.full.partialPivLu().solve(b);
        ASSERT_TRUE(sample.band.solve(sample.right_side)) << num_rings;
        const Eigen::VectorXd x =
            Eigen::Map<const Eigen::VectorXd>(sample.right_side.front().data(), size);
        EXPECT_LT((x - expected).norm(), 1e-12 * expected.norm()) << num_rings;
    }
}

TEST(RingBandMatrix, RefusesAMatrixThatIsNotPositiveDefinite)
{
    RingBandMatrix matrix(3, 4);
    for (int node = 0; node < 12; ++node)
        matrix.add(node, node, (node == 7 ? -1.0 : 1.0) * Eigen::Matrix3d::Identity());
    std::vector<Vec3> x(12, Vec3::Ones());
    EXPECT_FALSE(matrix.solve(x));
}

// As presses of a table and deployments of a diagnosis are.
TEST(RingBandMatrix, SolvesTheSameBesideOthers)
{
    const Sample sample = random_sample(6, 8);
    Sample alone = sample;
    ASSERT_TRUE(alone.band.solve(alone.right_side));
    std::atomic<int> others = 0;
    const auto solve_often = [&] {
        for (int i = 0; i < 2000; ++i) {
            Sample again = sample;
            if (!again.band.solve(again.right_side) || again.right_side != alone.right_side)
                ++others;
        }
    };
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back(solve_often);
    threads.clear();
    EXPECT_EQ(others, 0);
}

TEST(RingBandMatrix, CanBeFilledAgain)
{
    RingBandMatrix matrix(3, 4);
    for (double value : {2.0, 4.0}) {
        matrix.set_zero();
        for (int node = 0; node < 12; ++node)
            matrix.add(node, node, value * Eigen::Matrix3d::Identity());
        std::vector<Vec3> x(12, Vec3::Ones());
        ASSERT_TRUE(matrix.solve(x));
        EXPECT_DOUBLE_EQ(x[11].z(), 1.0 / value);
    }
    EXPECT_EQ(matrix.num_rings(), 3);
}

}  // namespace braidzone
