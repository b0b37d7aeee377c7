// The deployed surface follows a parameter smoothly: what a diagnosis takes for the trace of an
// effect must not be the deployment's own scatter. Measured as the mean radius of patches of 0.8 mm
// by 30 degrees about a polynomial through a sweep of the parameter, patch by patch.

#include "core/centerline_io.hpp"
#include "core/surface_io.hpp"
#include "deploy/deployment.hpp"
#include "support/devices_of_any_size.hpp"
#include "support/patches.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <vector>

namespace braidzone {
namespace {

/// The vessel of the sidewall case: a neck of 4.5 mm about 15 mm of arc length.
struct Sidewall {
    Vessel vessel;
    WallTree wall;
    Centerline centerline;
};

Sidewall read_sidewall()
{
    const std::filesystem::path folder =
        std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases/sidewall_aneurysm";
    const LengthUnit mm;
    Vessel vessel = make_vessel(read_surface(folder / "vessel.stl", mm), mm);
    WallTree wall(vessel);
    Centerline centerline = resample(read_centerline(folder / "centerline.vtp", mm));
    return {std::move(vessel), std::move(wall), std::move(centerline)};
}

/// Where the device lies in every sweep but that over push, 1 mm from its ends.
constexpr test::PatchGrid whole_device{.from = 7.5e-3, .along = 20};

/// Scatter of patch means about a smooth curve [m].
struct Scatter {
    double median = 0.0;
    double percentile_95 = 0.0;
    double max = 0.0;
};

/// Residuals of the patches about polynomials in the parameter.
/// @param means  one row for each value of the parameter
/// @param moved  only the patches whose range over the sweep exceeds this [m]
Scatter scatter(const std::vector<std::vector<double>>& means, int degree, double moved)
{
    const auto count = static_cast<Eigen::Index>(means.size());
    const auto num_patches = static_cast<Eigen::Index>(means.front().size());
    Eigen::MatrixXd basis(count, degree + 1);
    Eigen::MatrixXd values(count, num_patches);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double x = 2.0 * static_cast<double>(i) / static_cast<double>(count - 1) - 1.0;
        for (int power = 0; power <= degree; ++power)
            basis(i, power) = std::pow(x, power);
        for (Eigen::Index j = 0; j < num_patches; ++j)
            values(i, j) = means[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
    const Eigen::MatrixXd residuals = values - basis * basis.householderQr().solve(values);
    std::vector<double> sizes;
    for (Eigen::Index j = 0; j < num_patches; ++j) {
        if (!(values.col(j).maxCoeff() - values.col(j).minCoeff() >= moved)) continue;
        for (Eigen::Index i = 0; i < count; ++i)
            sizes.push_back(std::abs(residuals(i, j)));
    }
    if (sizes.empty()) return {};
    std::sort(sizes.begin(), sizes.end());
    const auto at = [&](double share) {
        return sizes[static_cast<std::size_t>(share * static_cast<double>(sizes.size() - 1))];
    };
    return {at(0.5), at(0.95), sizes.back()};
}

/// Points of a sweep: few, or 31 if the environment variable BRAIDZONE_SWEEP is set.
int sweep_points()
{
    return std::getenv("BRAIDZONE_SWEEP") == nullptr ? 9 : 31;
}

/// The patch means along a sweep of a parameter from `from` to `to`.
std::vector<std::vector<double>> sweep(double from, double to, const test::PatchGrid& patches,
                                       const std::function<Deployment(double)>& deployment_at)
{
    const int count = sweep_points();
    const double end = patches.from + patches.along * patches.length;
    std::vector<std::vector<double>> means;
    for (int i = 0; i < count; ++i) {
        const double value = from + (to - from) * i / (count - 1);
        const Deployment deployment = deployment_at(value);
        EXPECT_TRUE(deployment.converged)
            << "at " << value << ": residual " << deployment.max_force_residual << " N, tolerance "
            << deployment.force_tolerance << " N after " << deployment.steps << " steps";
        EXPECT_LT(deployment.ring_arc_length.back() + 0.5e-3, patches.from);
        EXPECT_GT(deployment.ring_arc_length.front() - 0.5e-3, end);
        means.push_back(test::patch_means(deployment, patches));
        for (const double mean : means.back())
            EXPECT_TRUE(std::isfinite(mean));
    }
    return means;
}

void print(const std::string& name, const std::vector<std::vector<double>>& means, int degree)
{
    const Scatter all = scatter(means, degree, 0.0), moved = scatter(means, degree, 10e-6);
    fmt::print(
        "{}: {} points, degree {}: median {:.3f}, 95 % {:.3f}, max {:.3f} um; patches that "
        "move by 10 um or more: {:.3f}, {:.3f}, {:.3f} um\n",
        name, means.size(), degree, 1e6 * all.median, 1e6 * all.percentile_95, 1e6 * all.max,
        1e6 * moved.median, 1e6 * moved.percentile_95, 1e6 * moved.max);
}

constexpr double wanted_scatter = 3e-6;  // [m]

}  // namespace

TEST(SmoothResponse, ToTheLandingPosition)
{
    const Sidewall sidewall = read_sidewall();
    const FlowDiverter device = test::pipeline(4e-3);
    const auto means = sweep(24.6e-3, 25.6e-3, whole_device, [&](double landing) {
        return deploy(device, sidewall.centerline, sidewall.wall, landing, {});
    });
    print("landing 24.6 to 25.6 mm", means, 2);
    EXPECT_LT(scatter(means, 2, 0.0).percentile_95, wanted_scatter);
}

TEST(SmoothResponse, ToTheDiameter)
{
    const Sidewall sidewall = read_sidewall();
    const auto means = sweep(3.9e-3, 4.2e-3, whole_device, [&](double diameter) {
        return deploy(test::pipeline(diameter), sidewall.centerline, sidewall.wall, 25e-3, {});
    });
    print("diameter 3.9 to 4.2 mm", means, 3);
    EXPECT_LT(scatter(means, 3, 0.0).percentile_95, wanted_scatter);
}

TEST(SmoothResponse, IsTheSameBytesWhenRepeated)
{
    const Sidewall sidewall = read_sidewall();
    const ReleaseSchedule push{.windows = {{12e-3, 18e-3, 0.6}}};
    const auto once = [&] {
        return deploy(test::pipeline(4e-3), sidewall.centerline, sidewall.wall, 25e-3, push);
    };
    const Deployment first = once(), second = once();
    ASSERT_EQ(first.nodes.size(), second.nodes.size());
    for (std::size_t node = 0; node < first.nodes.size(); ++node) {
        ASSERT_EQ(first.nodes[node], second.nodes[node]) << node;
        ASSERT_EQ(first.contact_force[node], second.contact_force[node]) << node;
    }
}

// A push shortens the device by up to 6 mm, so that the patches begin at the neck's proximal rim.
TEST(SmoothResponse, ToThePush)
{
    const Sidewall sidewall = read_sidewall();
    const FlowDiverter device = test::pipeline(4e-3);
    const auto means = sweep(1.0, 0.4, {.from = 12.4e-3, .along = 14}, [&](double spacing) {
        return deploy(device, sidewall.centerline, sidewall.wall, 25e-3,
                      {.windows = {{13e-3, 17e-3, spacing}}});
    });
    print("spacing 1.0 to 0.4", means, 4);
    EXPECT_LT(scatter(means, 4, 0.0).percentile_95, wanted_scatter);
}

}  // namespace braidzone
