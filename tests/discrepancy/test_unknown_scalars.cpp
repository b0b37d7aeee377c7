#include "discrepancy/unknown_scalars.hpp"
#include "support/patch_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {

// One length of 0.3 mm, with 0.2 mm of the floor: s^2 = 0.13 mm^2. Off by 2 mm, in mm:
// B = 1/2 sum over b = 1, 4 of sqrt(s^2 / (s^2 + b^2)) exp(1/2 (1/s^2 - 1/(s^2 + b^2)) 2^2).
TEST(UnknownScalarsEvidence, IsTheMeanOfTwoNormalRatios)
{
    Observations observations{.points = {}, .field = test::cylinder_field(3, 2e-3), .scalars = {}};
    observations.scalars.values[2] = {18e-3, 0.3e-3};
    NoiseFloor floor;
    floor.length_sd = 0.2e-3;
    const DiagnosisProblem problem = test::errors_of(observations, floor);
    Eigen::VectorXd residuals = Eigen::VectorXd::Zero(num_residuals(observations));
    residuals[residuals.size() - 1] = 2e-3;
    const auto ratio = [](double b) {
        const double s2 = 0.13;
        return std::sqrt(s2 / (s2 + b * b)) * std::exp(2.0 * (1.0 / s2 - 1.0 / (s2 + b * b)));
    };
    EXPECT_NEAR(unknown_scalars_evidence(problem, residuals),
                std::log(0.5 * (ratio(1.0) + ratio(4.0))), 1e-9);
}

TEST(UnknownScalarsEvidence, IsZeroWithoutScalars)
{
    const Observations observations{
        .points = {}, .field = test::cylinder_field(3, 2e-3), .scalars = {}};
    EXPECT_EQ(unknown_scalars_evidence(test::errors_of(observations), Eigen::VectorXd::Ones(36)),
              0.0);
}

}  // namespace braidzone
