#include "core/error.hpp"
#include "discrepancy/curve_noise_calibration.hpp"
#include "discrepancy/curve_noise_file.hpp"
#include "support/patch_grid.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

using testing::HasSubstr;

const CurveNoiseUnits units = {"force curve", "mN", "mm", 1e-3, 1e-3};

/// Curves of 25 points about a simulated one that rises from 1 to 13 mN over 3 mm.
std::vector<CurveCalibrationSet> drawn(const CurveNoise& truth, int count)
{
    CurveCalibrationSet set;
    for (int i = 0; i < 25; ++i) {
        set.measured.abscissae.push_back(0.125e-3 * i);
        set.simulated.push_back(1e-3 + 0.5e-3 * i);
    }
    const CurveWeights weights =
        make_curve_weights(set.measured.abscissae, set.simulated, 0.0, truth);
    const Eigen::MatrixXd draws = test::draws(weights.covariance, count, 31);
    std::vector<CurveCalibrationSet> sets;
    for (Eigen::Index i = 0; i < draws.cols(); ++i) {
        sets.push_back(set);
        const Eigen::VectorXd off = weights.weights.cwiseProduct(draws.col(i));
        for (std::size_t k = 0; k < set.simulated.size(); ++k) {
            sets.back().measured.ordinates.push_back(set.simulated[k] +
                                                     off[static_cast<Eigen::Index>(k)]);
        }
    }
    return sets;
}

std::string refusal(std::string text, const std::string& part, const std::string& replacement)
{
    const test::TemporaryFolder folder;
    text.replace(text.find(part), part.size(), replacement);
    try {
        read_curve_noise(folder.write("noise.json", text), units);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace

// A standard deviation from n draws is known to 1 / sqrt(2 n): 10 % of the common factor of 50
// curves, 3 % of the points' own; the background has some four independent pieces in each curve.
TEST(CalibrateCurveNoise, FindsTheNoiseThatTheCurvesWereDrawnFrom)
{
    const CurveNoise truth{.point_sd = 0.02,
                           .scale_sd = 0.06,
                           .background_sd = 0.05,
                           .background_length = 0.12,
                           .source = {}};
    const CurveNoise shipped{.point_sd = 0.01,
                             .scale_sd = 0.03,
                             .background_sd = 0.02,
                             .background_length = 0.2,
                             .source = {}};
    const CurveNoise found = calibrate_curve_noise(drawn(truth, 50), shipped);
    EXPECT_NEAR(found.point_sd, truth.point_sd, 0.15 * truth.point_sd);
    EXPECT_NEAR(found.scale_sd, truth.scale_sd, 0.3 * truth.scale_sd);
    EXPECT_NEAR(found.background_sd, truth.background_sd, 0.2 * truth.background_sd);
    EXPECT_NEAR(found.background_length, truth.background_length, 0.4 * truth.background_length);
    EXPECT_EQ(found.absolute_sd, 0.0) << "shipped as 0";
    EXPECT_EQ(found.source, "learned from 50 curves without an effect");
}

// Only an error along the abscissa: 0.05 mm on a slope of 4 mN/mm.
TEST(CalibrateCurveNoise, FindsAnErrorAlongTheAbscissa)
{
    const CurveNoise truth{
        .point_sd = 0.005, .background_length = 0.2, .abscissa_sd = 0.05e-3, .source = {}};
    CurveNoise shipped = truth;
    shipped.abscissa_sd = 0.02e-3;
    const CurveNoise found = calibrate_curve_noise(drawn(truth, 50), shipped);
    EXPECT_NEAR(found.abscissa_sd, truth.abscissa_sd, 0.15 * truth.abscissa_sd);
}

TEST(CalibrateCurveNoise, NeedsThreeCurves)
{
    EXPECT_THROW(calibrate_curve_noise(drawn(force_noise(), 2), force_noise()), InputError);
}

TEST(CurveNoiseFile, IsReadBackAsItWasWritten)
{
    const test::TemporaryFolder folder;
    CurveNoise noise = force_noise();
    noise.absolute_sd = 0.3e-3;
    noise.source = "9 curves";
    const std::string text = curve_noise_text(noise, units);
    EXPECT_THAT(text, testing::AllOf(HasSubstr("\"absolute_sd_mN\": 0.3"),
                                     HasSubstr("\"abscissa_sd_mm\": 0.02")));
    const CurveNoise read = read_curve_noise(folder.write("noise.json", text), units);
    EXPECT_NEAR(read.absolute_sd, 0.3e-3, 1e-18);
    EXPECT_NEAR(read.abscissa_sd, noise.abscissa_sd, 1e-18);
    EXPECT_EQ(read.point_sd, noise.point_sd);
    EXPECT_EQ(read.background_length, noise.background_length);
    EXPECT_EQ(read.source, "9 curves");
}

TEST(CurveNoiseFile, RefusesWhatIsNone)
{
    const std::string text = curve_noise_text(force_noise(), units);
    EXPECT_THAT(refusal(text, "scale_sd", "scal_sd"),
                HasSubstr("\"scal_sd\" is not known; did you mean \"scale_sd\"?"));
    EXPECT_THAT(refusal(text, "\"scale_sd\": 0.02", "\"scale_sd\": -1"),
                HasSubstr("scale_sd = -1; allowed are numbers from 0"));
    EXPECT_THAT(refusal(text, "\"scale_sd\": 0.02,", ""), HasSubstr("scale_sd is missing"));
    EXPECT_THAT(refusal(text, "force curve", "pressure drop"),
                HasSubstr("\"curve\" is \"pressure drop\"; needed is \"force curve\""));
    EXPECT_THROW(read_curve_noise("/nowhere/noise.json", units), IoError);
}

}  // namespace braidzone
