#include "discrepancy/discrepancy_clusters.hpp"
#include "support/patch_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

Observations cylinder()
{
    return {.points = {}, .field = test::cylinder_field(20, 2e-3), .scalars = {}};
}

}  // namespace

// Family-wise: 5 % of maps without an effect hold a cluster below p = 0.05. Of 200, 10 +- 3.1.
TEST(DiscrepancyMap, RaisesFalseAlarmsAtTheStatedRate)
{
    const Observations observations = cylinder();
    const ErrorModel error = make_error_model(observations, {});
    const Eigen::MatrixXd draws = test::draws(error.covariance(), 200, 2);
    int alarms = 0;
    for (Eigen::Index i = 0; i < draws.cols(); ++i) {
        const DiscrepancyMap map =
            make_discrepancy_map(observations.field, error, draws.col(i), {.num_draws = 400});
        alarms += !map.clusters.empty() && map.clusters.front().p_family_wise < 0.05 ? 1 : 0;
    }
    EXPECT_GE(alarms, 2);
    EXPECT_LE(alarms, 20);
}

TEST(DiscrepancyMap, PlacesABump)
{
    const Observations observations = cylinder();
    const ErrorModel error = make_error_model(observations, {});
    Eigen::VectorXd medians = test::draws(error.covariance(), 1, 4).col(0);
    const double angle = 2.0 * std::numbers::pi * 100.0 / 360.0;
    const Vec3 place(2e-3 * std::cos(angle), 2e-3 * std::sin(angle), 9e-3);
    for (Eigen::Index i = 0; i < medians.size(); ++i) {
        const Vec3& centre = observations.field.patches[static_cast<std::size_t>(i)].centre;
        medians[i] += 0.4e-3 * std::exp(-0.5 * (centre - place).squaredNorm() / 1.5e-6);
    }
    const DiscrepancyMap map = make_discrepancy_map(observations.field, error, medians);
    ASSERT_FALSE(map.clusters.empty());
    const Cluster& cluster = map.clusters.front();
    EXPECT_LT(cluster.p_family_wise, 0.002);
    EXPECT_NEAR(cluster.arc_length, 9e-3, 0.5e-3);
    EXPECT_NEAR(cluster.angle, angle, 0.25);
    EXPECT_GT(cluster.mean_gap, 0.08e-3);
    EXPECT_GT(cluster.largest_gap, cluster.mean_gap);
    EXPECT_LT(cluster.from, 9e-3);
    EXPECT_GT(cluster.to, 9e-3);
    EXPECT_DOUBLE_EQ(cluster.contact_share, 1.0);
}

// A motion of the scan is no discrepancy, however large.
TEST(DiscrepancyMap, DoesNotSeeTheRegistration)
{
    const Observations observations = cylinder();
    const ErrorModel error = make_error_model(observations, {});
    Eigen::VectorXd motion(6);
    motion << 1e-3, -2e-3, 0.5e-3, 0.1, 0.05, -0.2;
    const DiscrepancyMap map =
        make_discrepancy_map(observations.field, error, error.motion * motion);
    EXPECT_LT(map.gap.cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_TRUE(map.clusters.empty());
}

TEST(DiscrepancyMap, IsTheSameWhenRepeated)
{
    const Observations observations = cylinder();
    const ErrorModel error = make_error_model(observations, {});
    const Eigen::VectorXd medians = 2.0 * test::draws(error.covariance(), 1, 9).col(0);
    const DiscrepancyMap first = make_discrepancy_map(observations.field, error, medians);
    const DiscrepancyMap second = make_discrepancy_map(observations.field, error, medians);
    ASSERT_EQ(first.clusters.size(), second.clusters.size());
    for (std::size_t i = 0; i < first.clusters.size(); ++i)
        EXPECT_EQ(first.clusters[i].p_family_wise, second.clusters[i].p_family_wise);
}

TEST(SmoothingMatrix, KeepsAConstant)
{
    const Eigen::MatrixXd smoothing = smoothing_matrix(test::cylinder_field(4, 2e-3), 0.8e-3);
    EXPECT_LT((smoothing.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-12);
}

}  // namespace braidzone
