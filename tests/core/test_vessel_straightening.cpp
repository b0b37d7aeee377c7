#include "core/error.hpp"
#include "core/phantom_file.hpp"
#include "core/surface_check.hpp"
#include "core/vessel.hpp"
#include "core/vessel_straightening.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

using testing::HasSubstr;

constexpr double bend_radius = 10e-3, tube_radius = 2e-3;

Vec3 on_arc(double radius, double angle)
{
    return {bend_radius - radius * std::cos(angle), radius * std::sin(angle), 0.0};
}

/// An arc of a circle about (10 mm, 0, 0) from the origin, in the direction y at first.
Centerline arc(double angle)
{
    Polyline line;
    for (int i = 0; i <= 60; ++i) {
        line.points.push_back(on_arc(bend_radius, angle * i / 60));
        line.inscribed_radii.push_back(tube_radius);
    }
    return resample(line, {.spacing = 0.1e-3, .smoothing = 0.0});
}

/// The tube about that arc.
TriangleMesh bent_tube(double angle, double radius = tube_radius)
{
    TriangleMesh mesh = test::tube(radius, bend_radius * angle, 48, 60);
    for (Vec3& p : mesh.points) {
        const double place = p.z() / bend_radius;
        p = on_arc(bend_radius - p.x(), place) + Vec3(0.0, 0.0, p.y());
    }
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

VesselStraightening everywhere(double share)
{
    return {.share = share, .centre = 0.0, .half_width = 1.0};
}

double distance_from_line(const Vec3& point, const Vec3& start, const Vec3& end)
{
    return (point - start).cross((end - start).normalized()).norm();
}

std::string refusal(const VesselStraightening& straightening)
{
    try {
        validate(straightening);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

// A bend of pi / 3 at 10 mm becomes a straight tube of 10.472 mm, of the same radius.
TEST(Straightened, MakesAStraightTubeOfABend)
{
    const double angle = std::numbers::pi / 3.0;
    const TriangleMesh tube = bent_tube(angle);
    const auto [wall, line] = straightened(tube, arc(angle), everywhere(1.0));
    const Vec3 start = line.sections.front().origin, end = line.sections.back().origin;
    EXPECT_NEAR((end - start).norm(), bend_radius * angle, 1e-8);
    for (const CrossSection& section : line.sections)
        EXPECT_LT(distance_from_line(section.origin, start, end), 1e-8);
    for (std::size_t i = 0; i < wall.points.size(); ++i)
        EXPECT_NEAR(distance_from_line(wall.points[i], start, end), tube_radius, 1e-7) << i;
}

// Half of the curvature: an arc of 20 mm, whose chord over 10.472 mm is 40 sin(pi / 12) mm.
TEST(Straightened, DoublesTheRadiusOfABendForHalfOfItsCurvature)
{
    const double angle = std::numbers::pi / 3.0;
    const auto [wall, line] = straightened(bent_tube(angle), arc(angle), everywhere(0.5));
    const Vec3 chord = line.sections.back().origin - line.sections.front().origin;
    EXPECT_NEAR(chord.norm(), 40e-3 * std::sin(std::numbers::pi / 12.0), 1e-8);
    const double turn = std::acos(line.sections.front().tangent.dot(line.sections.back().tangent));
    EXPECT_NEAR(turn, 0.5 * angle, 1e-6);
    EXPECT_TRUE(is_sound(find_defects(wall)));
}

// By symmetry the least motion leaves the middle section in its plane; the middle of the arc of
// 20 mm moves inwards by as much as its mean, (sin a / a) 20 mm from its centre, comes nearer to
// the chord than that of the arc of 10 mm.
// The sum over 101 sections exceeds the integral by the ends' 0.4 mm over 100.
TEST(Straightened, MovesTheKeptStretchLeast)
{
    const double angle = 1.0;  // a section stands in the middle
    const Centerline before = arc(angle);
    VesselStraightening half = everywhere(0.5);
    half.kept_from = 0.0;
    half.kept_to = before.length();
    const Centerline after = straightened(bent_tube(angle), before, half).centerline;
    const std::size_t middle = before.sections.size() / 2;
    const auto rise = [](double radius, double half_angle) {
        return radius * (1.0 - std::sin(half_angle) / half_angle);
    };
    const Vec3 way = after.sections[middle].origin - before.sections[middle].origin;
    const Vec3 inwards = before.sections[middle].tangent.cross(-Vec3::UnitZ());
    EXPECT_NEAR(std::abs(way.dot(inwards)), rise(10e-3, angle / 2.0) - rise(20e-3, angle / 4.0),
                5e-6);
    EXPECT_NEAR(way.norm(), std::abs(way.dot(inwards)), 2e-6);
    EXPECT_NEAR(after.sections[middle].tangent.dot(before.sections[middle].tangent), 1.0, 1e-6);
}

// Beyond the window the vessel keeps its shape: distances there do not change. The fourth part of
// the bend at 1 - share of its curvature, and quarters that fade by half of that on average.
TEST(Straightened, LeavesTheShapeBeyondItsWindow)
{
    const double angle = std::numbers::pi / 2.0;
    const Centerline before = arc(angle);
    const VesselStraightening local{
        .share = 0.6, .centre = 0.5 * before.length(), .half_width = 3e-3};
    const Centerline after = straightened(bent_tube(angle), before, local).centerline;
    const std::size_t last = before.sections.size() - 1;
    const auto distance = [](const Centerline& line, std::size_t i, std::size_t j) {
        return (line.sections[i].origin - line.sections[j].origin).norm();
    };
    EXPECT_NEAR(distance(after, 0, 40), distance(before, 0, 40), 1e-12);
    EXPECT_NEAR(distance(after, last - 40, last), distance(before, last - 40, last), 1e-12);
    const double turn =
        std::acos(after.sections.front().tangent.dot(after.sections.back().tangent));
    EXPECT_NEAR(turn, angle - 0.6 * (3e-3 + 0.5 * 3e-3) / bend_radius, 1e-4);
}

TEST(Straightened, LeavesAVesselAloneAtShareZero)
{
    const TriangleMesh tube = bent_tube(1.0);
    const auto [wall, line] = straightened(tube, arc(1.0), {});
    for (std::size_t i = 0; i < tube.points.size(); ++i)
        EXPECT_EQ(wall.points[i], tube.points[i]);
    const auto [near, near_line] = straightened(tube, arc(1.0), everywhere(1e-9));
    for (std::size_t i = 0; i < tube.points.size(); ++i)
        EXPECT_LT((near.points[i] - tube.points[i]).norm(), 1e-10);
}

TEST(Straightened, KeepsASidewallAneurysmSound)
{
    const PhantomVessel made = make_phantom(read_phantom(TomlTable::read_file(
        std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases/sidewall_aneurysm/phantom.toml")));
    const Centerline centerline = resample(made.centerline);
    for (const double share : {0.5, 1.0}) {
        const auto [wall, line] = straightened(
            made.wall, centerline, {.share = share, .centre = 15e-3, .half_width = 10e-3});
        EXPECT_TRUE(is_sound(find_defects(wall))) << share;
        EXPECT_EQ(make_vessel(wall, LengthUnit{}).openings.size(), 2u);
    }
}

// A tube of 9.5 mm about a bend of 10 mm: at its inner side an edge of 0.5 mm / 10 mm of its arc
// would be drawn out to twenty times its length.
TEST(Straightened, RefusesAWallThatTears)
{
    try {
        straightened(bent_tube(1.0, 9.5e-3), arc(1.0), everywhere(1.0));
        FAIL() << "no GeometryError";
    } catch (const GeometryError& error) {
        EXPECT_THAT(error.what(), HasSubstr("vessel.straightening tears the wall near ("));
        EXPECT_THAT(error.what(), HasSubstr("take a smaller share"));
    }
}

TEST(Straightened, RefusesWhatIsOutOfRange)
{
    EXPECT_EQ(refusal({}), "accepted");
    EXPECT_EQ(refusal({.share = 1.2, .half_width = 1e-3}),
              "straightening: share = 1.2; allowed are 0 (as it is) to 1 (straight)");
    EXPECT_EQ(refusal({.share = 0.2}), "straightening: half_width = 0 mm; it must be positive");
    EXPECT_THAT(refusal({.centre = std::nan("")}), HasSubstr("is no place"));
    try {
        straightened(bent_tube(1.0), arc(1.0), {.share = 0.5, .centre = 50e-3, .half_width = 5e-3});
        FAIL() << "no GeometryError";
    } catch (const GeometryError& error) {
        EXPECT_THAT(error.what(), HasSubstr("off the centerline, which runs from 0 to 10 mm"));
    }
}

}  // namespace braidzone
