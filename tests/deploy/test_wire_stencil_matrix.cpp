#include "deploy/wire_stencil_matrix.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

namespace braidzone {
namespace {

BraidLattice small_lattice(int nodes_per_ring, std::array<int, 2> arm_steps)
{
    BraidLattice lattice;
    lattice.nodes_per_ring = nodes_per_ring;
    lattice.num_rings = 4;
    lattice.arm_steps = arm_steps;
    return lattice;
}

/// The same random entries in a matrix of stencils and in a full one.
struct Sample {
    WireStencilMatrix stencils;
    Eigen::MatrixXd full;
};

Sample random_sample(const BraidLattice& lattice)
{
    const int n = lattice.num_nodes();
    Sample sample{WireStencilMatrix(lattice), Eigen::MatrixXd::Zero(n, n)};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int node = 0; node < n; ++node) {
        const int ring = node / lattice.nodes_per_ring, column = node % lattice.nodes_per_ring;
        const double own = number(random);
        sample.stencils.add_own(node, own);
        sample.full(node, node) += own;
        for (const std::size_t family : {0u, 1u}) {
            const int step = lattice.arm_steps[family];
            const double next = number(random), second = number(random);
            const auto add_to_full = [&](int rings_on, double value) {
                const int around = (column + rings_on * step + 3 * lattice.nodes_per_ring) %
                                   lattice.nodes_per_ring;
                const int other = lattice.node(ring + rings_on, around);
                sample.full(node, other) += value;
                sample.full(other, node) += value;
            };
            if (ring + 1 < lattice.num_rings) {
                sample.stencils.add_next(node, family, next);
                add_to_full(1, next);
            }
            if (ring + 2 < lattice.num_rings) {
                sample.stencils.add_second(node, family, second);
                add_to_full(2, second);
            }
        }
    }
    return sample;
}

void expect_lower_triangle(const Sample& sample, const std::vector<int>& kept)
{
    std::vector<int> places(static_cast<std::size_t>(sample.full.rows()), -1);
    for (std::size_t i = 0; i < kept.size(); ++i)
        places[static_cast<std::size_t>(kept[i])] = static_cast<int>(i);
    const Eigen::MatrixXd lower =
        sample.stencils.lower_triangle(places, static_cast<int>(kept.size()));
    const Eigen::MatrixXd part = sample.full(kept, kept);
    const Eigen::MatrixXd expected = part.triangularView<Eigen::Lower>();
    EXPECT_LT((lower - expected).cwiseAbs().maxCoeff(), 1e-15);
}

std::vector<int> all_nodes(const Sample& sample)
{
    std::vector<int> all;
    for (int node = 0; node < sample.full.rows(); ++node)
        all.push_back(node);
    return all;
}

}  // namespace

TEST(WireStencilMatrix, IsTheFullMatrix)
{
    const Sample sample = random_sample(small_lattice(7, {-1, 0}));
    expect_lower_triangle(sample, all_nodes(sample));
}

TEST(WireStencilMatrix, LeavesNodesOut)
{
    expect_lower_triangle(random_sample(small_lattice(7, {-1, 0})),
                          {0, 1, 5, 6, 7, 8, 13, 14, 20, 26, 27});
}

// Six columns on, along either wire, is the same node of a ring of twelve: its entries add up.
TEST(WireStencilMatrix, AddsUpWhereBothWiresMeetTheSameNode)
{
    const Sample sample = random_sample(small_lattice(12, {-3, 3}));
    expect_lower_triangle(sample, all_nodes(sample));
}

TEST(WireStencilMatrix, IsEmptyAfterSetZero)
{
    const BraidLattice lattice = small_lattice(5, {-1, 0});
    Sample sample = random_sample(lattice);
    sample.stencils.set_zero();
    sample.full.setZero();
    expect_lower_triangle(sample, all_nodes(sample));
}

}  // namespace braidzone
