#include "discrepancy/linear_refit.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// |z + S (y - x)|^2 + |y|^2 has its minimum at (S'S + I)^-1 S' (S x - z).
Eigen::VectorXd minimum(const Eigen::VectorXd& z, const Eigen::MatrixXd& s,
                        const Eigen::VectorXd& x)
{
    const Eigen::MatrixXd curvature =
        s.transpose() * s + Eigen::MatrixXd::Identity(x.size(), x.size());
    return curvature.inverse() * s.transpose() * (s * x - z);
}

const Eigen::Vector3d z(3.0, -1.0, 2.0);
const Eigen::MatrixXd slope = (Eigen::MatrixXd(3, 2) << 1.0, 0.5, -2.0, 1.0, 0.0, 3.0).finished();
const Eigen::Vector2d x(0.3, -0.4);

}  // namespace

TEST(LinearRefit, IsTheMinimumFromAnywhere)
{
    const std::vector<EffectParameter> free(2, normal_parameter("a", "1", 0.0, 1.0, -9.0, 9.0));
    const LinearRefit refit = linear_refit(z, slope, x, free);
    EXPECT_LT((refit.x - minimum(z, slope, x)).norm(), 1e-12);
    EXPECT_LT((refit.whitened - (z + slope * (refit.x - x))).norm(), 1e-12);
    const LinearRefit again = linear_refit(refit.whitened, slope, refit.x, free);
    EXPECT_LT((again.x - refit.x).norm(), 1e-12);
    EXPECT_NEAR(again.log_evidence, refit.log_evidence, 1e-12);
}

// The first parameter may not fall below -0.9, 1.2 of its prior's standard deviations below the
// mean of 0.3: the second is the minimum with the first held there.
TEST(LinearRefit, KeepsTheBounds)
{
    const std::vector<EffectParameter> bounded = {normal_parameter("a", "1", 0.3, 1.0, -0.9, 9.0),
                                                  normal_parameter("b", "1", 0.0, 1.0, -9.0, 9.0)};
    const Eigen::Vector2d start(-0.9, 0.2);
    ASSERT_LT(minimum(z, slope, start)[0], -1.2);
    const LinearRefit refit = linear_refit(z, slope, start, bounded);
    EXPECT_DOUBLE_EQ(refit.x[0], -1.2);
    const Eigen::VectorXd with_first = z + slope.col(0) * -0.3;
    EXPECT_NEAR(refit.x[1], minimum(with_first, slope.col(1), start.tail(1))[0], 1e-12);
}

TEST(LinearRefit, OfAUniformParameterHasNoPull)
{
    const std::vector<EffectParameter> uniform = {uniform_parameter("a", "1", -9.0, 9.0, 0.1)};
    const Eigen::MatrixXd column = slope.col(0);
    // x in units of the prior: the minimum of |z + S (y - x)|^2 alone.
    const double expected = 0.3 - column.col(0).dot(z) / column.squaredNorm();
    EXPECT_NEAR(linear_refit(z, column, x.head(1), uniform).x[0], expected, 1e-12);
}

}  // namespace braidzone
