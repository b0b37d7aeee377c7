#include "core/error.hpp"
#include "discrepancy/device_surface.hpp"
#include "discrepancy/imaging_chain.hpp"
#include "support/straight_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace braidzone {
namespace {

using testing::HasSubstr;

constexpr double pi = std::numbers::pi;

/// Blur whose standard deviation is `deviation`, with voxels too small to matter.
ImagingChain blurred_by(double deviation, double threshold = 0.5)
{
    return {.blur = std::sqrt(8.0 * std::numbers::ln2) * deviation, .threshold = threshold};
}

/// Where a function falls through a level.
double crossing(const std::function<double(double)>& f, double level, double from, double to)
{
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (from + to);
        (f(middle) > level ? from : to) = middle;
    }
    return from;
}

/// Grey at a distance r from the middle of a sphere of radius R whose skin, without thickness, is
/// blurred by a Gaussian of deviation s, over that of a flat skin in its middle: closed form.
double blurred_sphere(double r, double radius, double s)
{
    const auto bell = [&](double distance) {
        return std::exp(-0.5 * distance * distance / (s * s));
    };
    return radius / r * (bell(r - radius) - bell(r + radius));
}

/// The same for a cylinder: R / s sqrt(2 pi) exp(-(r^2 + R^2) / 2 s^2) I0(r R / s^2).
double blurred_cylinder(double r, double radius, double s)
{
    // I0(x) e^-x, the mean of exp(x (cos a - 1)) over a turn, by the trapezoidal rule, which is
    // exact to rounding here.
    const double x = r * radius / (s * s);
    double mean = 0.0;
    constexpr int num_angles = 400;
    for (int i = 0; i < num_angles; ++i)
        mean += std::exp(x * (std::cos(2.0 * pi * i / num_angles) - 1.0)) / num_angles;
    const double u = (r - radius) / s;
    return radius / s * std::sqrt(2.0 * pi) * std::exp(-0.5 * u * u) * mean;
}

/// Mean distance, from the middle, of the points where a surface drawn from the voxels of a blurred
/// spherical skin cuts the edges between the voxels' centres, as the corners of marching cubes do.
/// A voxel's value is the mean of the closed form over its box (Gauss's rule, 3 points an axis).
double drawn_sphere(double radius, double s, double voxel, double level)
{
    const double offset = 0.31 * voxel;  // no symmetry between grid and sphere
    const std::array<double, 3> places = {-0.5 * std::sqrt(0.6) * voxel, 0.0,
                                          0.5 * std::sqrt(0.6) * voxel};
    const std::array<double, 3> weights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    const auto value = [&](const Vec3& centre) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3 point = centre + Vec3(places[i], places[j], places[k]);
                    sum += weights[i] * weights[j] * weights[k] *
                           blurred_sphere(point.norm(), radius, s);
                }
            }
        }
        return sum;
    };
    const int n = static_cast<int>(std::ceil((radius + 5.0 * s) / voxel));
    double sum = 0.0;
    int count = 0;
    // Along each axis, from the middle outwards in both senses.
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = -n; i <= n; ++i) {
            for (int j = -n; j <= n; ++j) {
                const auto centre = [&](int k) {
                    Vec3 c;
                    c[axis] = k * voxel + offset;
                    c[(axis + 1) % 3] = i * voxel + 0.7 * offset;
                    c[(axis + 2) % 3] = j * voxel - 0.4 * offset;
                    return c;
                };
                // From far outside to the first voxel above the level: the outer face.
                for (const int sense : {-1, 1}) {
                    double outer = 0.0;
                    for (int k = sense * n; sense * k >= 0; k -= sense) {
                        const double inner = value(centre(k));
                        if (inner > level) {
                            const double share = (level - outer) / (inner - outer);
                            sum += (centre(k + sense) + share * (centre(k) - centre(k + sense)))
                                       .norm();
                            ++count;
                            break;
                        }
                        outer = inner;
                    }
                }
            }
        }
    }
    return sum / count;
}

double shift_of(const std::vector<double>& shifts, const BraidLattice& lattice, int ring)
{
    return shifts[static_cast<std::size_t>(lattice.node(ring, 3))];
}

}  // namespace

// FWHM 0.3 mm: 0.3 / 2.3548 = 0.12740 mm. Voxels of 0.2 mm: 0.2 / sqrt(12) = 0.057735 mm. Together
// sqrt(0.016230 + 0.003333) = 0.139870 mm; with a second h^2 / 12, sqrt(0.022897) = 0.151317 mm.
TEST(BlurDeviation, MatchesHandCalculation)
{
    EXPECT_NEAR(blur_deviation({.blur = 0.3e-3}), 0.127398e-3, 1e-9);
    EXPECT_NEAR(blur_deviation({.voxel_size = 0.2e-3}), 0.057735e-3, 1e-9);
    EXPECT_NEAR(blur_deviation({.voxel_size = 0.2e-3, .blur = 0.3e-3}), 0.139870e-3, 1e-9);
    EXPECT_NEAR(drawn_deviation({.voxel_size = 0.2e-3, .blur = 0.3e-3}), 0.151317e-3, 1e-9);
}

// Half the full width at half maximum, sqrt(2 ln 2) sigma; exp(-u^2 / 2 s^2) = t elsewhere.
TEST(ApparentHalfThickness, OfAThinSheetIsThatOfTheBlur)
{
    const double s = 0.15e-3;
    for (const double threshold : {0.1, 0.5, 0.9}) {
        EXPECT_NEAR(apparent_half_thickness(blurred_by(s, threshold), 1e-9),
                    s * std::sqrt(-2.0 * std::log(threshold)), 1e-9);
    }
}

// The blurred edge of a thick sheet is at half its grey where the edge is; Phi(-1) = 0.158655 lies
// one deviation outside, Phi(1) inside.
TEST(ApparentHalfThickness, OfAThickSheetIsItsOwn)
{
    const double s = 0.02e-3, thickness = 1e-3;
    EXPECT_NEAR(apparent_half_thickness(blurred_by(s), thickness), 0.5e-3, 1e-9);
    EXPECT_NEAR(apparent_half_thickness(blurred_by(s, 0.1586553), thickness), 0.52e-3, 1e-9);
    EXPECT_NEAR(apparent_half_thickness(blurred_by(s, 0.8413447), thickness), 0.48e-3, 1e-9);
}

// sigma = 0.1 mm from the point spread alone and h = 0.2 mm: sigma^2 = 0.013333, s^2 = 0.016667
// mm^2, u = s sqrt(2 ln(sigma / (0.5 s))) = 0.129099 sqrt(2 (0.693147 - 0.111572)) = 0.139233 mm.
TEST(ApparentHalfThickness, IsDrawnBetweenTheVoxels)
{
    ImagingChain chain = blurred_by(0.1e-3);
    chain.voxel_size = 0.2e-3;
    EXPECT_NEAR(apparent_half_thickness(chain, 1e-9), 0.139233e-3, 1e-9);
}

// Larger voxels alone, no level between a flat sheet's own largest and what is drawn.
TEST(ApparentHalfThickness, IsNoneAboveAllThatIsDrawn)
{
    EXPECT_EQ(apparent_half_thickness({.voxel_size = 0.2e-3, .threshold = 0.95}, 1e-9), 0.0);
}

// The closed forms of blurred skins: the error of the first order in the curvature falls with its
// square.
TEST(CurvatureShift, IsOfFirstOrderInTheCurvature)
{
    const double s = 0.15e-3;
    const double u = apparent_half_thickness(blurred_by(s), 1e-9);
    const auto errors = [&](double radius) {
        const auto outer = [&](const auto& grey, double shift) {
            const double r = crossing([&](double at) { return grey(at, radius, s); }, 0.5, radius,
                                      radius + 5.0 * s);
            return std::abs(r - (radius + u + shift));
        };
        return std::array{outer(blurred_cylinder, -0.5 * s * s / radius),
                          outer(blurred_sphere, -s * s / radius)};
    };
    const auto coarse = errors(1e-3), fine = errors(2e-3);
    for (const std::size_t i : {0u, 1u}) {
        EXPECT_GT(coarse[i] / fine[i], 3.3);
        EXPECT_LT(coarse[i] / fine[i], 4.7);
        EXPECT_LT(fine[i], 1e-6);
    }
}

// A sphere's skin, blurred, voxelised and contoured, against the closed form of a blur that holds
// the variances of the voxel's box and of the contour: what is left falls with the fourth power of
// the voxel's edge. Of the contour's variance, h^2 / 6 along the edges that are cut, half lies
// along the normal and half across; the closed form has as much along each axis, a curvature shift
// too large by h^2 / (24 R).
TEST(ImagingChain, IsWhatContouredVoxelsShow)
{
    const double radius = 1e-3, s = 0.13e-3;
    const auto error = [&](double voxel) {
        ImagingChain chain = blurred_by(s);
        chain.voxel_size = voxel;
        // Half of what a flat skin has in its middle; a skin's grey goes with 1 / deviation.
        const double level = 0.5 * s / blur_deviation(chain);
        const double drawn = drawn_deviation(chain);
        const double expected =
            crossing([&](double r) { return s / drawn * blurred_sphere(r, radius, drawn); }, level,
                     radius, radius + 5.0 * s) +
            voxel * voxel / (24.0 * radius);
        return std::abs(drawn_sphere(radius, s, voxel, level) - expected);
    };
    const double coarse = error(0.3e-3), fine = error(0.2e-3);
    EXPECT_GT(coarse / fine, 1.5 * 1.5 * 1.5);
    EXPECT_LT(fine, 0.3e-6);
}

// -s^2 / (2 R) = -0.15^2 / 4 mm = -5.625 um on a cylinder of 2 mm, ends included; crossings are
// sparse for the quadrature of the weight, 0.1 mm by 0.26 mm.
TEST(BlurShifts, OfACylinderAreThoseOfItsCurvature)
{
    const Deployment device = test::straight_device(2e-3, 10e-3, 97);
    const double s = 0.15e-3;
    const std::vector<double> shifts = blur_shifts(device, s);
    for (const int ring : {0, 1, 40, 60, 96})
        EXPECT_NEAR(shift_of(shifts, device.lattice, ring), -0.25 * s * s / 1e-3, 0.4e-6) << ring;
}

// A ridge of the sheet is worn off and a groove filled.
TEST(BlurShifts, WearOffARidge)
{
    Deployment device = test::straight_device(2e-3, 10e-3, 97);
    const double s = 0.15e-3;
    const auto with_ridge = [&](double height) {
        Deployment changed = device;
        for (int ring = 47; ring <= 49; ++ring) {
            for (int column = 0; column < 24; ++column) {
                Vec3& node =
                    changed.nodes[static_cast<std::size_t>(device.lattice.node(ring, column))];
                node.head<2>() *= 1.0 + height / 2e-3;
            }
        }
        return shift_of(blur_shifts(changed, s), device.lattice, 48);
    };
    EXPECT_LT(with_ridge(0.05e-3), with_ridge(0.0));
    EXPECT_GT(with_ridge(-0.05e-3), 0.0);
}

// Of wires of 30 um, blurred by 0.15 mm: the outer face of a cylinder of 2 mm lies u - s^2 / (2 R)
// outside the crossings.
TEST(ImagedSheet, IsSeenByTheDeviceSurface)
{
    const Deployment device = test::straight_device(2e-3, 10e-3, 97);
    const ImagingChain chain = blurred_by(0.15e-3);
    const DeviceSurface plain(device), imaged(device, imaged_sheet(device, 30e-6, chain));
    const double u = apparent_half_thickness(chain, 60e-6);
    EXPECT_GT(u, 0.17e-3);
    const Vec3 point(2.4e-3 * std::cos(0.1), 2.4e-3 * std::sin(0.1), 5.02e-3);
    EXPECT_NEAR(plain.nearest(point).distance - imaged.nearest(point).distance, u - 5.625e-6,
                0.4e-6);
}

TEST(ImagedSheet, IsTheCrossingsWithoutAVolume)
{
    const Deployment device = test::straight_device(2e-3, 10e-3);
    const ImagedSheet sheet = imaged_sheet(device, 30e-6, {});
    EXPECT_EQ(sheet.middle, device.nodes);
    EXPECT_EQ(sheet.half_thickness, 0.0);
}

TEST(ImagingChain, RefusesWhatNoVolumeHas)
{
    const auto refusal = [](const ImagingChain& chain) -> std::string {
        try {
            validate(chain);
        } catch (const ConfigError& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(refusal({.voxel_size = 0.2e-3, .blur = 0.3e-3}), "none");
    EXPECT_THAT(refusal({.voxel_size = -0.1e-3}), HasSubstr("measurement.voxel_size = -0.1 mm"));
    EXPECT_THAT(refusal({.blur = std::nan("")}), HasSubstr("measurement.blur = nan mm"));
    EXPECT_THAT(refusal({.threshold = 1.0}), HasSubstr("measurement.threshold = 1; it must lie"));
    EXPECT_THAT(refusal({.threshold = 0.0}), HasSubstr("measurement.threshold = 0; it must lie"));
}

}  // namespace braidzone
