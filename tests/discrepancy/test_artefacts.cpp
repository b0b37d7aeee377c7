#include "discrepancy/artefacts.hpp"
#include "support/straight_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

}  // namespace

TEST(OutlyingValues, AreFarInTheirStandardDeviationsIfAllAreIndependent)
{
    const Eigen::Vector4d sd(1.0, 2.0, 0.5, 1.0), values(3.0, -12.0, 2.6, 5.5);
    // 3, 6, 5.2 and 5.5 standard deviations
    EXPECT_THAT(outlying_values(sd.cwiseAbs2().asDiagonal(), values, 5.0), ElementsAre(1, 3, 2));
    EXPECT_THAT(outlying_values(sd.cwiseAbs2().asDiagonal(), values, 7.0), IsEmpty());
}

// Two values of correlation 0.8 and variance 1: the second is 0.8 times the first, give or take
// 0.6. Both at 6 go together; 6 beside 0 is off by 10, and 0 alone is then nothing special.
TEST(OutlyingValues, AreFarFromWhatTheOthersPredict)
{
    Eigen::Matrix2d covariance;
    covariance << 1.0, 0.8, 0.8, 1.0;
    EXPECT_THAT(outlying_values(covariance, Eigen::Vector2d(6.0, 6.0), 5.0), IsEmpty());
    EXPECT_THAT(outlying_values(covariance, Eigen::Vector2d(6.0, 0.0), 9.0), ElementsAre(0));
    EXPECT_THAT(outlying_values(covariance, Eigen::Vector2d(6.0, 0.0), 11.0), IsEmpty());
}

// A patch 0.6 mm off among others on the surface is an artefact; a bulge of 0.6 mm over 3 mm is
// not.
TEST(LeaveOutArtefacts, TakesSinglePatchesAndNoBulges)
{
    constexpr double turn = 2.0 * std::numbers::pi;
    Deployment device = test::straight_device(2e-3, 20e-3);
    DeviceSurface surface(device);
    const Simulation base{std::move(device), std::move(surface)};
    Observations observations;
    for (double z = 1.05e-3; z < 19e-3; z += 0.1e-3) {
        for (int j = 0; j < 48; ++j) {
            const double angle = turn * (j + 0.5) / 48;
            const double from_bulge = std::hypot(z - 6e-3, 2e-3 * (angle - 0.5 * turn));
            double radius = 2e-3 + 0.6e-3 * std::exp(-0.5 * std::pow(from_bulge / 1.5e-3, 2));
            if (z > 15.2e-3 && z < 16e-3 && angle < turn / 12) radius += 0.6e-3;
            observations.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
    }
    observations.field = make_discrepancy_field(observations.points, {}, base);
    const std::size_t before = observations.field.patches.size();
    const std::vector<Patch> artefacts = leave_out_artefacts(
        observations, residuals(observations, base, {}, base.surface), NoiseFloor{});
    ASSERT_EQ(artefacts.size(), 1u);
    EXPECT_EQ(artefacts.front().row, 19);
    EXPECT_EQ(artefacts.front().column, 0);
    EXPECT_EQ(observations.field.patches.size(), before - 1);
}

}  // namespace braidzone
