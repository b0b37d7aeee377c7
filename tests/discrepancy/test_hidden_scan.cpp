#include "support/hidden/hidden_case.hpp"
#include "support/hidden/hidden_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone::hidden {
namespace {

/// A straight tube of radius 2 mm about x, 19 mm long.
HiddenDevice tube()
{
    HiddenDevice device;
    device.rows = 20;
    device.columns = 200;
    device.row_step = 1e-3;
    for (int row = 0; row < device.rows; ++row) {
        device.arc_length.push_back(25e-3 - 1e-3 * row);
        for (int column = 0; column < device.columns; ++column) {
            const double angle = 2.0 * std::numbers::pi * column / device.columns;
            device.points.emplace_back(device.arc_length.back(), 2e-3 * std::cos(angle),
                                       2e-3 * std::sin(angle));
            device.radii.push_back(2e-3);
        }
    }
    return device;
}

ScanErrors no_errors()
{
    ScanErrors errors;
    errors.noise_sd = errors.bias_sd = errors.anisotropy = errors.voxel_pull = 0.0;
    errors.shift_sd = errors.angle_sd = errors.outlier_share = errors.artefact_share = 0.0;
    return errors;
}

double mean_radius(const std::vector<Vec3>& points)
{
    double sum = 0.0;
    for (const Vec3& p : points)
        sum += std::hypot(p.y(), p.z());
    return sum / static_cast<double>(points.size());
}

}  // namespace

// exp(-d^2 / (2 sigma^2)) falls to one half at sigma sqrt(2 ln 2), which is where the scanner's
// threshold expects the surface; a curved sheet is drawn in by sigma^2 / (2 R) = 5.6 um.
TEST(SegmentedOffset, IsThatOfABlurredSheet)
{
    EXPECT_NEAR(segmented_offset(0.15e-3, 0.15e-3, 0.0, 1e3), 0.0, 1e-9);
    EXPECT_NEAR(segmented_offset(0.15e-3, 0.15e-3, 0.1e-3, 1e3), 0.1e-3, 1e-9);
    EXPECT_NEAR(segmented_offset(0.15e-3, 0.15e-3, 0.0, 2e-3), -5.625e-6, 1e-9);
    // Nothing is left of a sheet above its peak.
    EXPECT_NEAR(segmented_offset(0.1e-3, 0.1e-3, -1e-3, 1e3),
                -0.1e-3 * std::sqrt(2.0 * std::numbers::ln2), 1e-9);
}

TEST(Scanned, LiesOnTheDeviceButForItsErrors)
{
    std::mt19937 random(1);
    ScanErrors errors = no_errors();
    const ScannedDevice scan = scanned(tube(), {}, errors, random);
    EXPECT_GT(scan.points.size(), 2300u);
    // 5.6 um of the blurred curved sheet; chords of 200 columns are 0.25 um deep.
    EXPECT_NEAR(mean_radius(scan.points), 2e-3 - 5.6e-6, 0.3e-6);

    random.seed(1);
    errors.noise_sd = 0.07e-3;
    double squares = 0.0;
    const std::vector<Vec3> noisy = scanned(tube(), {}, errors, random).points;
    for (const Vec3& p : noisy)
        squares += std::pow(std::hypot(p.y(), p.z()) - 2e-3, 2);
    // The standard deviation of n values is off by 1 / sqrt(2 n) of itself, 1.4 %: three of them.
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(noisy.size())), 0.07e-3, 3e-6);
}

TEST(Scanned, ShowsWhatIsHidden)
{
    std::mt19937 random(2), same(2);
    const ScannedDevice plain = scanned(tube(), {}, no_errors(), random);
    const Vec3 shift(0.3e-3, -0.1e-3, 0.2e-3);
    const ScannedDevice moved = scanned(tube(), {.shift = shift}, no_errors(), same);
    ASSERT_EQ(plain.points.size(), moved.points.size());
    for (std::size_t i = 0; i < plain.points.size(); i += 50)
        EXPECT_LT((moved.points[i] - plain.points[i] - shift).norm(), 1e-12);

    same.seed(2);
    const ScannedDevice bloomed = scanned(tube(), {.blooming = 0.1e-3}, no_errors(), same);
    EXPECT_NEAR(mean_radius(bloomed.points) - mean_radius(plain.points), 0.1e-3, 1e-6);
}

TEST(Scanned, MeasuresTheEnds)
{
    std::mt19937 random(3);
    double sum = 0.0, squares = 0.0;
    constexpr int count = 200;
    for (int i = 0; i < count; ++i) {
        const double error =
            scanned(tube(), {}, {.num_points = 50}, random).ends.values[0]->value - 25e-3;
        sum += error / count;
        squares += error * error / count;
    }
    // Means of 200 scatter by 0.02 mm, standard deviations by 5 %: three times that.
    EXPECT_NEAR(sum, 0.0, 0.064e-3);
    EXPECT_NEAR(std::sqrt(squares), 0.3e-3, 0.045e-3);
}

// Every effect can be made, and tells its parameters.
TEST(HiddenEffects, CanAllBeMade)
{
    for (const EffectMaker& maker : effect_makers()) {
        const EffectChoice choice{std::string(maker.name), EffectSize::strong};
        const HiddenCase made = random_case({&choice, 1}, 7);
        ASSERT_EQ(made.effects.size(), 1u);
        EXPECT_FALSE(made.effects.front().values.empty()) << maker.name;
        EXPECT_GT(made.scan.points.size(), 1500u) << maker.name;
    }
}

TEST(HiddenEffects, AreTheSameForTheSameSeed)
{
    const EffectChoice choice{"local_push", EffectSize::medium};
    const HiddenCase one = random_case({&choice, 1}, 9), other = random_case({&choice, 1}, 9);
    EXPECT_EQ(one.scan.points, other.scan.points);
    EXPECT_NE(one.scan.points, random_case({&choice, 1}, 10).scan.points);
}

}  // namespace braidzone::hidden
