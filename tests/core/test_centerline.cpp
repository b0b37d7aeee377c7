#include "core/centerline.hpp"
#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace braidzone {
namespace {

constexpr double pi = std::numbers::pi;

Polyline sampled(const std::function<Vec3(double)>& curve, double from, double to, int intervals,
                 double radius)
{
    Polyline line;
    for (int i = 0; i <= intervals; ++i) {
        line.points.push_back(curve(from + (to - from) * i / intervals));
        line.inscribed_radii.push_back(radius);
    }
    return line;
}

Vec3 circle(double radius, double angle)
{
    return radius * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

// A helix of radius a and pitch 2 pi b has speed c = sqrt(a^2 + b^2) and torsion b / c^2.
struct Helix {
    double a = 4e-3;
    double b = 1.5e-3;
    double speed() const { return std::hypot(a, b); }
    double torsion() const { return b / (speed() * speed()); }
    Vec3 point(double t) const { return {a * std::cos(t), a * std::sin(t), b * t}; }
    Vec3 tangent(double t) const { return Vec3(-a * std::sin(t), a * std::cos(t), b) / speed(); }
    Vec3 principal_normal(double t) const { return {-std::cos(t), -std::sin(t), 0.0}; }
};

// Angle of `normal` from the principal normal, about the tangent.
double frenet_angle(const Helix& helix, double t, const Vec3& normal)
{
    const Vec3 principal = helix.principal_normal(t);
    const Vec3 binormal = helix.tangent(t).cross(principal);
    return std::atan2(normal.dot(binormal), normal.dot(principal));
}

// Against the principal normal a frame that does not turn about the tangent turns by minus the
// integral of the torsion.
double frame_error(const Helix& helix, double spacing)
{
    const double end = 2.0 * pi;
    const Polyline line = sampled([&](double t) { return helix.point(t); }, 0.0, end, 4000, 1e-3);
    const Centerline centerline = resample(line, {.spacing = spacing, .smoothing = 0.0});
    const double turned = frenet_angle(helix, end, centerline.sections.back().normal) -
                          frenet_angle(helix, 0.0, centerline.sections.front().normal);
    const double expected = -helix.torsion() * helix.speed() * end;
    return std::abs(std::remainder(turned - expected, 2.0 * pi));
}

TEST(Resample, FrameIsFourthOrderAccurateOnAHelix)
{
    const Helix helix;
    const double coarse = frame_error(helix, 1.6e-3);
    const double middle = frame_error(helix, 0.8e-3);
    const double fine = frame_error(helix, 0.4e-3);
    EXPECT_NEAR(std::log2(coarse / middle), 4.0, 0.2);
    EXPECT_NEAR(std::log2(middle / fine), 4.0, 0.2);
    EXPECT_LT(fine, 1e-3);
}

TEST(Resample, FramesAreOrthonormalAndRightHanded)
{
    const Helix helix;
    const Centerline centerline =
        resample(sampled([&](double t) { return helix.point(t); }, 0.0, 5.0, 60, 1.5e-3));
    for (const CrossSection& section : centerline.sections) {
        EXPECT_NEAR(section.tangent.norm(), 1.0, 1e-12);
        EXPECT_NEAR(section.normal.norm(), 1.0, 1e-12);
        EXPECT_NEAR(section.tangent.dot(section.normal), 0.0, 1e-12);
        EXPECT_NEAR((section.tangent.cross(section.normal) - section.binormal).norm(), 0.0, 1e-12);
    }
}

// The arc length of the helix is its speed times the parameter.
TEST(Resample, ArcLengthIsUniformAndExact)
{
    const Helix helix;
    const Centerline centerline = resample(
        sampled([&](double t) { return helix.point(t); }, 0.0, 5.0, 400, 1e-3), {.smoothing = 0.0});
    EXPECT_NEAR(centerline.length(), 5.0 * helix.speed(), 1e-9);
    for (std::size_t i = 0; i < centerline.sections.size(); ++i) {
        const double t = static_cast<double>(i) * centerline.spacing / helix.speed();
        EXPECT_NEAR((centerline.sections[i].origin - helix.point(t)).norm(), 0.0, 1e-9);
    }
}

// Six points on a quarter circle of 6 mm, 1.9 mm apart: the tangents must follow the circle, not
// the chords, which differ from it by up to 9 degrees.
TEST(Resample, CoarsePolylineGetsSmoothTangents)
{
    const double radius = 6e-3;
    const Centerline centerline =
        resample(sampled([&](double t) { return circle(radius, t); }, 0.0, 0.5 * pi, 5, 1.8e-3),
                 {.smoothing = 0.0});
    double largest = 0.0;
    for (const CrossSection& section : centerline.sections) {
        const Vec3 radial = section.origin.normalized();
        largest = std::max(largest, std::abs(std::asin(section.tangent.dot(radial))));
        EXPECT_NEAR(section.origin.norm(), radius, 0.01 * radius);
    }
    EXPECT_LT(largest, 1.0 * pi / 180.0);
}

// The quadratic fit shifts a bend by (sigma / R)^4 / 8 of R: 0.3 um for sigma = 0.9 mm, R = 6 mm
// (a Gaussian mean would shift it by 68 um); at the ends, where the window is one-sided, the
// leading error is of third order in sigma / R.
TEST(Resample, SmoothingKeepsBendsAndTheirEnds)
{
    const double radius = 6e-3;
    const Polyline line =
        sampled([&](double t) { return circle(radius, t); }, 0.0, pi, 200, 1.8e-3);
    const Centerline centerline = resample(line, {.smoothing = 0.5});
    const std::size_t last = centerline.sections.size() - 1;
    EXPECT_NEAR(centerline.sections[last / 2].origin.norm(), radius, 1e-6);
    EXPECT_NEAR(centerline.length(), pi * radius, 2e-3 * pi * radius);
    EXPECT_EQ(centerline.sections.front().origin, line.points.front());
    EXPECT_NEAR((centerline.sections.back().origin - line.points.back()).norm(), 0.0, 1e-12);
    EXPECT_NEAR(centerline.sections.front().tangent.dot(Vec3::UnitY()), 1.0, 1e-3);
    EXPECT_NEAR(centerline.sections.back().tangent.dot(-Vec3::UnitY()), 1.0, 1e-3);
}

// Noise of 40 um at every 0.1 mm tilts the raw chords by tens of degrees.
TEST(Resample, SmoothingRemovesNoise)
{
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 40e-6);
    Polyline line = sampled([](double t) { return Vec3(t, 0.0, 0.0); }, 0.0, 20e-3, 200, 1.8e-3);
    for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {
        line.points[i] += Vec3(noise(random), noise(random), noise(random));
    }
    double rough = 0.0, smooth = 0.0;
    for (const CrossSection& section : resample(line, {.smoothing = 0.0}).sections) {
        rough = std::max(rough, std::acos(section.tangent.x()));
    }
    for (const CrossSection& section : resample(line, {.smoothing = 0.5}).sections) {
        smooth = std::max(smooth, std::acos(section.tangent.x()));
    }
    EXPECT_GT(rough, 20.0 * pi / 180.0);
    EXPECT_LT(smooth, 5.0 * pi / 180.0);
}

TEST(Resample, RepeatedPointsChangeNothing)
{
    const Polyline line = sampled([](double t) { return circle(8e-3, t); }, 0.0, 2.0, 50, 2e-3);
    Polyline repeated;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        for (int copy = 0; copy < (i % 7 == 0 ? 3 : 1); ++copy) {
            repeated.points.push_back(line.points[i]);
            repeated.inscribed_radii.push_back(line.inscribed_radii[i]);
        }
    }
    const Centerline a = resample(line), b = resample(repeated);
    ASSERT_EQ(a.sections.size(), b.sections.size());
    for (std::size_t i = 0; i < a.sections.size(); ++i) {
        EXPECT_EQ(a.sections[i].origin, b.sections[i].origin);
    }
}

TEST(Resample, StraightLineStaysStraightAndRadiiAreInterpolated)
{
    Polyline line;
    line.points = {Vec3(0, 0, 0), Vec3(0, 0, 4e-3), Vec3(0, 0, 10e-3)};
    line.inscribed_radii = {2e-3, 2e-3, 1e-3};
    const Centerline centerline = resample(line, {.spacing = 1e-3});
    ASSERT_EQ(centerline.sections.size(), 11u);
    for (std::size_t i = 0; i <= 10; ++i) {
        EXPECT_NEAR(
            (centerline.sections[i].origin - Vec3(0, 0, 1e-3 * static_cast<double>(i))).norm(), 0.0,
            1e-12);
        EXPECT_EQ(centerline.sections[i].normal, centerline.sections[0].normal);
    }
    EXPECT_NEAR(centerline.sections[2].inscribed_radius, 2e-3, 1e-12);
    EXPECT_NEAR(centerline.sections[7].inscribed_radius, 1.5e-3, 1e-5);
}

TEST(Resample, IsIndependentOfPlacement)
{
    const Helix helix;
    const Polyline line = sampled([&](double t) { return helix.point(t); }, 0.0, 4.0, 40, 1e-3);
    Polyline moved = line;
    const Eigen::AngleAxisd rotation(0.7, Vec3(1.0, 2.0, 3.0).normalized());
    for (Vec3& point : moved.points)
        point = rotation * point + Vec3(0.1, 0.2, 0.3);
    const Centerline a = resample(line), b = resample(moved);
    ASSERT_EQ(a.sections.size(), b.sections.size());
    for (std::size_t i = 0; i < a.sections.size(); ++i) {
        const Vec3 expected = rotation * a.sections[i].origin + Vec3(0.1, 0.2, 0.3);
        EXPECT_NEAR((b.sections[i].origin - expected).norm(), 0.0, 1e-12);
    }
}

void expect_refused(const Polyline& line, const ResampleOptions& options, const std::string& words)
{
    try {
        resample(line, options);
        FAIL() << "not refused: " << words;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(Resample, RefusesUnusablePolylines)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Vec3 a(0, 0, 0), b(0, 0, 1e-2);
    expect_refused({}, {}, "at least 2 are needed");
    expect_refused({{a}, {1e-3}}, {}, "1 points; at least 2");
    expect_refused({{a, a, a}, {1e-3, 1e-3, 1e-3}}, {}, "all 3 points of the centerline");
    expect_refused({{a, b}, {}}, {}, "2 points and 0 radii");
    expect_refused({{a, b}, {1e-3, 0.0}}, {}, "point 1 has radius 0 mm");
    expect_refused({{a, b}, {nan, 1e-3}}, {}, "point 0 has radius nan mm");
    expect_refused({{a, Vec3(0, nan, 0)}, {1e-3, 1e-3}}, {}, "point 1 is not finite");
    expect_refused({{a, b}, {1e-3, 1e-3}}, {.spacing = nan}, "centerline spacing = nan mm");
    expect_refused({{a, b}, {1e-3, 1e-3}}, {.smoothing = -1.0}, "must not be negative");
}

// Between sections the Hermite cubic leaves the circle by (h / R)^4 / 384 of R at most.
TEST(SectionAt, FollowsTheCurveBetweenSections)
{
    const double radius = 5e-3;
    const Centerline centerline =
        resample(sampled([&](double t) { return circle(radius, t); }, 0.0, 2.0, 500, 2e-3),
                 {.spacing = 0.5e-3, .smoothing = 0.0});
    for (double s = 0.0; s <= centerline.length(); s += 0.13e-3) {
        const CrossSection section = section_at(centerline, s);
        EXPECT_NEAR((section.origin - circle(radius, s / radius)).norm(), 0.0, 1e-8);
        EXPECT_NEAR(section.tangent.dot(section.normal), 0.0, 1e-12);
        EXPECT_NEAR((section.tangent.cross(section.normal) - section.binormal).norm(), 0.0, 1e-12);
    }
}

TEST(SectionAt, ReturnsTheSectionsAndRefusesTheOutside)
{
    const Centerline centerline =
        resample(sampled([](double t) { return circle(5e-3, t); }, 0.0, 2.0, 100, 2e-3));
    EXPECT_EQ(section_at(centerline, 0.0).origin, centerline.sections.front().origin);
    EXPECT_NEAR(
        (section_at(centerline, centerline.length()).origin - centerline.sections.back().origin)
            .norm(),
        0.0, 1e-15);
    EXPECT_THROW(section_at(centerline, -0.1e-3), InputError);
    EXPECT_THROW(section_at(centerline, centerline.length() + 0.1e-3), InputError);
    EXPECT_THROW(section_at(centerline, std::numeric_limits<double>::quiet_NaN()), InputError);
}

TEST(NearestArcLength, ProjectsOntoTheCenterline)
{
    Polyline line;
    line.points = {Vec3(0, 0, 0), Vec3(0, 0, 10e-3)};
    line.inscribed_radii = {1e-3, 1e-3};
    const Centerline centerline = resample(line);
    EXPECT_NEAR(nearest_arc_length(centerline, Vec3(2e-3, 1e-3, 3.217e-3)), 3.217e-3, 1e-12);
    EXPECT_EQ(nearest_arc_length(centerline, Vec3(0, 0, -1e-3)), 0.0);
    EXPECT_NEAR(nearest_arc_length(centerline, Vec3(0, 0, 1.0)), 10e-3, 1e-12);
}

}  // namespace
}  // namespace braidzone
