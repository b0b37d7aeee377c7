#include "core/error.hpp"
#include "discrepancy/background_estimate.hpp"
#include "discrepancy/error_model.hpp"
#include "discrepancy/whitening.hpp"
#include "support/patch_grid.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {

TEST(ErrorModel, HasTheStatedCovariance)
{
    Observations observations{.points = {}, .field = test::cylinder_field(6, 2e-3), .scalars = {}};
    observations.field.patches[3].hub_slope = 0.8;
    observations.field.patches[17].hub_slope = 0.5;
    NoiseFloor floor;
    floor.hub_sd = 0.03e-3;
    floor.white_scale = 1.2;
    floor.background_sd = 0.026e-3;
    floor.background_length = 2.2e-3;
    floor.offset_sd = 0.02e-3;
    const Eigen::MatrixXd covariance = make_error_model(observations, floor).covariance();
    const auto& patches = observations.field.patches;
    // Patches 3 and 17, by hand: the middle of the cylinder is at half its length.
    const Vec3 middle(0, 0, 3 * 0.8e-3);
    const auto motion = [&](std::size_t i) {
        Eigen::Matrix<double, 6, 1> row;
        row << floor.shift_sd * patches[i].normal,
            floor.angle_sd * (patches[i].centre - middle).cross(patches[i].normal);
        return row;
    };
    const double distance = (patches[3].centre - patches[17].centre).norm();
    const double expected = std::pow(0.026e-3, 2) * std::exp(-distance / 2.2e-3) +
                            std::pow(0.02e-3, 2) + 0.8 * 0.5 * std::pow(0.03e-3, 2) +
                            motion(3).dot(motion(17));
    EXPECT_NEAR(covariance(3, 17), expected, 1e-6 * expected);
    const double white = 1.2 * std::pow(test::patch_point_sd, 2) / test::patch_points;
    const double variance = white + std::pow(0.026e-3, 2) + std::pow(0.02e-3, 2) +
                            std::pow(0.8 * 0.03e-3, 2) + motion(3).squaredNorm();
    EXPECT_NEAR(covariance(3, 3), variance, 1e-6 * variance);
}

// Ends: the landing moves both, an error of the length the proximal end only.
TEST(ErrorModel, GivesTheScalarsABlockOfTheirOwn)
{
    Observations observations{.points = {}, .field = test::cylinder_field(2, 2e-3), .scalars = {}};
    observations.scalars.values = {MeasuredValue{25e-3, 0.3e-3}, MeasuredValue{5e-3, 0.2e-3},
                                   MeasuredValue{20e-3, 0.1e-3}};
    NoiseFloor floor;
    floor.landing_sd = 0.15e-3;
    floor.length_sd = 0.2e-3;
    const Eigen::MatrixXd all = make_error_model(observations, floor).covariance();
    const Eigen::MatrixXd ends = 1e6 * all.bottomRightCorner(3, 3);  // [mm^2]
    EXPECT_NEAR(ends(0, 0), 0.09 + 0.0225, 1e-9);
    EXPECT_NEAR(ends(1, 1), 0.04 + 0.0225 + 0.04, 1e-9);
    EXPECT_NEAR(ends(2, 2), 0.01 + 0.04, 1e-9);
    EXPECT_NEAR(ends(0, 1), 0.0225, 1e-9);
    EXPECT_NEAR(ends(1, 2), -0.04, 1e-9);
    EXPECT_NEAR(ends(0, 2), 0.0, 1e-9);
    EXPECT_EQ(all.topRightCorner(24, 3).norm(), 0.0);
}

TEST(Whitening, MakesTheCovarianceTheIdentity)
{
    const Observations observations{
        .points = {}, .field = test::cylinder_field(5, 2e-3), .scalars = {}};
    const Eigen::MatrixXd covariance = make_error_model(observations, {}).covariance();
    const Whitening whitening(covariance);
    const Eigen::MatrixXd white =
        whitening.of_columns(whitening.of_columns(covariance).transpose());
    EXPECT_LT((white - Eigen::MatrixXd::Identity(60, 60)).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(whitening.log_determinant(),
                covariance.selfadjointView<Eigen::Lower>().eigenvalues().array().log().sum(), 1e-6);
}

TEST(Whitening, RefusesWhatIsNoCovariance)
{
    EXPECT_THROW(Whitening(-Eigen::MatrixXd::Identity(2, 2)), InputError);
}

// Drawn at 1 and at 2.5 times the background, 16 maps each.
TEST(BackgroundScale, TellsATooSmallNoiseFloor)
{
    const Observations observations{
        .points = {}, .field = test::cylinder_field(20, 2e-3), .scalars = {}};
    const ErrorModel error = make_error_model(observations, {});
    for (const double scale : {1.0, 2.5}) {
        NoiseFloor larger;
        larger.background_sd *= scale;
        const Eigen::MatrixXd draws =
            test::draws(make_error_model(observations, larger).covariance(), 16, 7);
        double mean = 0.0;
        for (Eigen::Index i = 0; i < draws.cols(); ++i)
            mean += background_scale(error, draws.col(i)) / 16.0;
        EXPECT_NEAR(mean, scale, 0.15 * scale);
        EXPECT_EQ(mean > largest_background_scale, scale > 1.5);
    }
}

}  // namespace braidzone
