#include "core/error.hpp"
#include "discrepancy/error_model.hpp"
#include "discrepancy/noise_calibration.hpp"
#include "support/patch_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

std::vector<CalibrationSet> sets_of(const NoiseFloor& truth, int count)
{
    const Observations observations{
        .points = {}, .field = test::cylinder_field(15, 2e-3), .scalars = {}};
    const Eigen::MatrixXd draws =
        test::draws(make_error_model(observations, truth).covariance(), count, 21);
    std::vector<CalibrationSet> sets;
    for (Eigen::Index i = 0; i < draws.cols(); ++i)
        sets.push_back({observations, draws.col(i)});
    return sets;
}

}  // namespace

// Drawn from a known floor: the background comes back within its sampling error, about 1 / sqrt(2
// n) with some 40 independent pieces of 2 mm in each of 12 maps.
TEST(CalibrateNoiseFloor, FindsTheFloorThatTheSetsWereDrawnFrom)
{
    NoiseFloor truth;
    truth.background_sd = 0.045e-3;
    truth.background_length = 1.5e-3;
    truth.white_scale = 1.3;
    truth.shift_sd = 0.15e-3;
    const NoiseFloor found = calibrate_noise_floor(sets_of(truth, 12));
    EXPECT_NEAR(found.background_sd, truth.background_sd, 0.15 * truth.background_sd);
    EXPECT_NEAR(found.background_length, truth.background_length, 0.35 * truth.background_length);
    EXPECT_NEAR(found.white_scale, truth.white_scale, 0.15 * truth.white_scale);
    EXPECT_NEAR(found.shift_sd, truth.shift_sd, 0.4 * truth.shift_sd);
    EXPECT_EQ(found.source, "learned from 12 measurements without an effect");
}

TEST(CalibrateNoiseFloor, NeedsSets)
{
    try {
        calibrate_noise_floor(sets_of({}, 2));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("at least 3 measurements without an effect; 2 "
                                                     "given"));
    }
}

}  // namespace braidzone
