// The default deployment holds in bends as tight as the vessel is wide. More of them, and the
// network of wires beside it: bends/README.md.

#include "support/bent_tube.hpp"
#include "support/patches.hpp"
#include "verification/bends/bend.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace braidzone::test {
namespace {

class DeployInBend : public testing::TestWithParam<double> {};

// Planes across the vessel would meet at the bend's centre, within a wire of its inner wall: real
// wires neither cross nor come nearer than their diameter.
TEST_P(DeployInBend, NeitherJamsNorTurnsARhombusOver)
{
    for (const double device_ratio : {1.08, 1.25}) {
        const BendOutcome outcome =
            outcome_of({.bend_ratio = GetParam(), .device_ratio = device_ratio});
        EXPECT_EQ(outcome.refused, "");
        EXPECT_TRUE(outcome.converged);
        EXPECT_EQ(outcome.inverted, 0);
        EXPECT_EQ(outcome.outside, 0);
        EXPECT_EQ(outcome.jammed, 0);
    }
}

// A wall that gives way does not let the wires come nearer than they can. 1e7 Pa/m: 40 um for the
// 400 Pa that a device presses with here.
TEST_P(DeployInBend, NeitherJamsBehindAWallThatGivesWay)
{
    const BendOutcome outcome =
        outcome_of({.bend_ratio = GetParam(), .device_ratio = 1.16, .wall_stiffness = 1e7});
    EXPECT_EQ(outcome.refused, "");
    EXPECT_TRUE(outcome.converged);
    EXPECT_EQ(outcome.inverted, 0);
    EXPECT_EQ(outcome.jammed, 0);
}

TEST_P(DeployInBend, KeepsTheWiresLengthAtForceFreeSpacing)
{
    const BendOutcome outcome = outcome_of({.bend_ratio = GetParam(),
                                            .angle = 0.75 * std::numbers::pi,
                                            .device_ratio = 1.08,
                                            .force_free = true});
    EXPECT_EQ(outcome.refused, "");
    EXPECT_EQ(outcome.inverted, 0);
    EXPECT_EQ(outcome.outside, 0);
    EXPECT_EQ(outcome.jammed, 0);
    EXPECT_LT(std::abs(outcome.wire_stretch), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Radii, DeployInBend, testing::Values(1.0, 1.1, 1.25, 1.5));

/// Distance of patch means from cubics through a sweep of a parameter, of 95 % of them [m].
double scatter(double from, double to, const std::function<Deployment(double)>& deployment_at)
{
    constexpr int count = 9, num_patches = 36;
    const PatchGrid patches{.from = 1.4e-3, .length = 0.5e-3, .along = 3};
    Eigen::MatrixXd basis(count, 4), values(count, num_patches);
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1);
        const Deployment deployment = deployment_at(std::lerp(from, to, share));
        const std::vector<double> means = patch_means(deployment, patches);
        basis.row(i) << 1.0, share, share * share, share * share * share;
        for (int j = 0; j < num_patches; ++j)
            values(i, j) = means[static_cast<std::size_t>(j)];
    }
    const Eigen::MatrixXd residuals = values - basis * basis.householderQr().solve(values);
    std::vector<double> sizes;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < num_patches; ++j)
            sizes.push_back(std::abs(residuals(i, j)));
    }
    std::sort(sizes.begin(), sizes.end());
    const double range = (values.colwise().maxCoeff() - values.colwise().minCoeff()).maxCoeff();
    const double most = sizes[sizes.size() * 95 / 100];
    fmt::print("range {:.1f} um; from the curve: 95 % {:.3f}, max {:.3f} um\n", 1e6 * range,
               1e6 * most, 1e6 * sizes.back());
    return most;
}

constexpr BentTube tight{.radius = 1.8e-3, .bend_radius = 1.86e-3, .angle = 2.6};

FlowDiverter short_device(double diameter = 4e-3)
{
    FlowDiverter device = pipeline(diameter);
    device.nominal_length = 3e-3;
    return device;
}

// Constraints of planes and stops of jammed nodes come and go along a sweep: 3 um, as elsewhere
// (test_smooth_response.cpp).
TEST(SmoothResponseInABend, ToTheLandingPosition)
{
    const WallTree wall(tight.vessel(96, 200));
    const Centerline centerline = tight.centerline();
    EXPECT_LT(scatter(4.0e-3, 4.5e-3,
                      [&](double landing) {
                          return deploy(short_device(), centerline, wall, landing, {});
                      }),
              3e-6);
}

TEST(SmoothResponseInABend, ToTheDiameter)
{
    const WallTree wall(tight.vessel(96, 200));
    const Centerline centerline = tight.centerline();
    EXPECT_LT(scatter(3.8e-3, 4.2e-3,
                      [&](double diameter) {
                          return deploy(short_device(diameter), centerline, wall, 4.2e-3, {});
                      }),
              3e-6);
}

// As the bend tightens beyond the radius at which the first planes touch.
TEST(SmoothResponseInABend, ToTheRadiusOfTheBend)
{
    EXPECT_LT(scatter(2.1e-3, 2.5e-3,
                      [&](double bend_radius) {
                          const BentTube bend{
                              .radius = 1.8e-3, .bend_radius = bend_radius, .angle = 2.2};
                          return deploy(short_device(), bend.centerline(),
                                        WallTree(bend.vessel(96, 120)), 4.2e-3, {});
                      }),
              3e-6);
}

}  // namespace
}  // namespace braidzone::test
