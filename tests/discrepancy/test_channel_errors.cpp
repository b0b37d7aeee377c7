#include "discrepancy/channel_errors.hpp"
#include "discrepancy/implementation_error.hpp"
#include "discrepancy/unknown_scalars.hpp"
#include "support/patch_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

/// Six patches; one length, two densities 1 mm apart and a force.
Observations all_channels()
{
    Observations observations{.points = {}, .field = test::cylinder_field(1, 2e-3), .scalars = {}};
    observations.field.patches.resize(6);
    observations.scalars.values[2] = {18e-3, 0.3e-3};
    observations.scalars.contact_force = {.force = {0.5, 0.02}};
    DensityField& density = observations.density;
    density.places = {{.value = 20e6, .sd = 2e6}, {.value = 30e6, .sd = 3e6}};
    density.feet = {Vec3::Zero(), Vec3(0.0, 0.0, 1e-3)};
    density.scale = Eigen::Vector2d(22e6, 25e6);
    return observations;
}

}  // namespace

TEST(ResidualRows, StandInOrder)
{
    const ResidualRows rows = residual_rows(all_channels());
    EXPECT_EQ(rows.lengths, 6);
    EXPECT_EQ(rows.density, 7);
    EXPECT_EQ(rows.num_density, 2);
    EXPECT_EQ(rows.force, 9);
    EXPECT_EQ(rows.size, 10);
}

// Relative errors of 1 % over 3 mm and 5 % in common: by hand.
TEST(ChannelErrors, AreRelativeToTheDensityAndTheForce)
{
    NoiseFloor floor;
    floor.density_sd = 0.01;
    floor.background_length = 3e-3;
    floor.density_scale_sd = 0.05;
    floor.force_sd = 0.2;
    const Eigen::MatrixXd c = make_error_model(all_channels(), floor).covariance();
    EXPECT_NEAR(c(7, 7), 4e12 + 22e6 * 22e6 * (1e-4 + 25e-4), 1e6);
    EXPECT_NEAR(c(7, 8), 22e6 * 25e6 * (1e-4 * std::exp(-1.0 / 3.0) + 25e-4), 1e6);
    EXPECT_NEAR(c(9, 9), 0.02 * 0.02 + 0.1 * 0.1, 1e-12);
    EXPECT_EQ(c.block(0, 7, 7, 3).norm(), 0.0);
    EXPECT_EQ(c(8, 9), 0.0);
}

// Each channel alone may be off, in its own unit: a force off by 0.4 N, in units of 20 % of 0.5 N.
TEST(UnknownChannels, LetTheForceBeOffInItsOwnUnit)
{
    Observations observations{.points = {}, .field = test::cylinder_field(1, 2e-3), .scalars = {}};
    observations.scalars.contact_force = {.force = {0.5, 0.02}};
    NoiseFloor floor;
    floor.force_sd = 0.1;
    const DiagnosisProblem problem = test::errors_of(observations, floor);
    Eigen::VectorXd residuals = Eigen::VectorXd::Zero(13);
    residuals[12] = 0.4;
    const double s2 = 0.02 * 0.02 + 0.05 * 0.05;
    const auto ratio = [&](double b2) {
        return std::sqrt(s2 / (s2 + b2)) * std::exp(0.5 * (1.0 / s2 - 1.0 / (s2 + b2)) * 0.16);
    };
    EXPECT_NEAR(unknown_scalars_evidence(problem, residuals),
                std::log(0.5 * (ratio(0.01) + ratio(0.16))), 1e-9);
}

// The mean over the channels: what one of three is off by counts a third.
TEST(UnknownChannels, AreAlikeProbable)
{
    const Observations observations = all_channels();
    DiagnosisProblem problem = test::errors_of(observations);
    Eigen::VectorXd residuals = Eigen::VectorXd::Zero(10);
    residuals[6] = 8e-3;  // a length far off
    const double of_all = unknown_scalars_evidence(problem, residuals);
    problem.unknown_channels.resize(1);  // lengths alone
    EXPECT_NEAR(of_all, unknown_scalars_evidence(problem, residuals) - std::log(3.0), 1e-3);
}

// rho m of the densities and the force, correlated among densities over 3.6 mm; none of the length.
TEST(ImplementationError, ReachesDensityAndForce)
{
    const Observations observations = all_channels();
    DiagnosisProblem problem = test::errors_of(observations);
    problem.shape_correlation = shape_correlation(observations, 3.6e-3);
    Eigen::VectorXd change = Eigen::VectorXd::Zero(10);
    change.tail(4) << 2e-3, 10e6, -5e6, 0.3;
    const Eigen::MatrixXd more =
        with_implementation_error(problem, {}, change, 0.2) - problem.covariance;
    EXPECT_EQ(more(6, 6), 0.0);
    EXPECT_NEAR(more(7, 7), 2e6 * 2e6, 1.0);
    EXPECT_NEAR(more(7, 8), 2e6 * 1e6 * std::exp(-1.0 / 3.6), 1e6);
    EXPECT_NEAR(more(9, 9), 0.06 * 0.06, 1e-12);
}

}  // namespace braidzone
