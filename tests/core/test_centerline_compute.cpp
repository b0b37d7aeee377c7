#include "core/centerline_compute.hpp"
#include "core/centerline_io.hpp"
#include "core/error.hpp"
#include "core/phantom.hpp"
#include "core/surface_io.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

namespace braidzone {
namespace {

const LengthUnit mm{"mm", 1e-3};

/// Largest and mean distance of a path from the true axis, over the vessel's radius there.
struct Deviation {
    double largest = 0.0;
    double mean = 0.0;
};

Deviation deviation(const Polyline& path, const Centerline& axis)
{
    Deviation result;
    for (const Vec3& point : path.points) {
        const CrossSection section = section_at(axis, nearest_arc_length(axis, point));
        const double relative = (section.origin - point).norm() / section.inscribed_radius;
        result.largest = std::max(result.largest, relative);
        result.mean += relative / static_cast<double>(path.points.size());
    }
    return result;
}

struct ShippedVessel {
    const char* name;
    double largest;  ///< allowed deviation over the radius
};

class ComputeCenterlineOfCase : public testing::TestWithParam<ShippedVessel> {};

// The aim is 5 % of the radius everywhere, under a sac's neck too, where the wall that is left
// decides; without a sac the wall's flat triangles, which lie up to 1 % of the radius inside the
// round wall, set the limit.
TEST_P(ComputeCenterlineOfCase, FollowsTheParentVesselsAxis)
{
    const auto folder = std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases" / GetParam().name;
    const Vessel vessel = make_vessel(read_surface(folder / "vessel.stl", mm), mm);
    const WallTree wall(vessel);
    const Polyline exact = read_centerline(folder / "centerline.vtp", mm);
    const Polyline computed =
        compute_centerline(vessel, wall, exact.points.front(), exact.points.back());

    const Centerline axis = resample(exact, {.smoothing = 0.0});
    const Deviation found = deviation(computed, axis);
    EXPECT_LT(found.largest, GetParam().largest);
    EXPECT_LT(found.mean, 0.01);
    EXPECT_NEAR(resample(computed).length(), axis.length(), 0.002 * axis.length());
    EXPECT_EQ(computed.points.front(), exact.points.front());
    EXPECT_NEAR((computed.points.back() - exact.points.back()).norm(), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Cases, ComputeCenterlineOfCase,
                         testing::Values(ShippedVessel{"straight_tube", 0.01},
                                         ShippedVessel{"curved_tube", 0.01},
                                         ShippedVessel{"sidewall_aneurysm", 0.05},
                                         ShippedVessel{"tortuous", 0.05},
                                         ShippedVessel{"giant", 0.05}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(ComputeCenterline, RadiusIsTheDistanceToTheWall)
{
    const Vessel vessel = test::tube_vessel(1.8e-3, 12e-3, 48, 24);
    const WallTree wall(vessel);
    const Polyline line = compute_centerline(vessel, wall, Vec3(0, 0, 0), Vec3(0, 0, 12e-3));
    // The prism of 48 sides has an inscribed cylinder of cos(pi / 48) of its radius.
    for (const double radius : line.inscribed_radii) {
        EXPECT_NEAR(radius, 1.8e-3 * std::cos(std::numbers::pi / 48), 1e-3 * 1.8e-3);
    }
}

// From and to may be any points of the lumen: the path begins there and finds to the middle.
TEST(ComputeCenterline, BeginsAtPointsInTheLumen)
{
    const Vessel vessel = test::tube_vessel(1.8e-3, 20e-3, 48, 40);
    const WallTree wall(vessel);
    const Vec3 from(0.6e-3, 0, 4e-3), to(0, -0.6e-3, 16e-3);
    const Polyline line = compute_centerline(vessel, wall, from, to);
    EXPECT_EQ(line.points.front(), from);
    EXPECT_EQ(line.points.back(), to);
    for (const Vec3& point : line.points) {
        if (point.z() < 6e-3 || point.z() > 14e-3) continue;
        EXPECT_LT(std::hypot(point.x(), point.y()), 0.03 * 1.8e-3);
    }
}

TEST(ComputeCenterline, FollowsASideBranch)
{
    Phantom phantom;
    phantom.segments = {{.length = 14e-3}};
    phantom.branches = {{.position = 6e-3, .radius = 1.2e-3, .length = 9e-3}};
    const Vessel vessel = make_vessel(make_phantom(phantom).wall, mm);
    const WallTree wall(vessel);
    const Vec3 along(0.5, std::sqrt(0.75), 0.0);  // 60 degrees from the axis
    const Vec3 end = Vec3(6e-3, 0, 0) + 9e-3 * along;
    const Polyline line = compute_centerline(vessel, wall, Vec3(0, 0, 0), end);
    for (const Vec3& point : line.points) {
        const Vec3 offset = point - Vec3(6e-3, 0, 0);
        const double in_branch = offset.dot(along);
        if (point.x() < 3e-3) {
            EXPECT_LT(std::hypot(point.y(), point.z()), 0.05 * 2e-3);
        } else if (in_branch > 4.5e-3) {
            EXPECT_LT((offset - in_branch * along).norm(), 0.05 * 1.2e-3);
        }
    }
}

TEST(ComputeCenterline, IsTheSameFromRunToRun)
{
    const Vessel vessel = test::tube_vessel(1.8e-3, 12e-3, 48, 24);
    const WallTree wall(vessel);
    const Vec3 from(0, 0, 0), to(0, 0, 12e-3);
    const Polyline a = compute_centerline(vessel, wall, from, to);
    const Polyline b = compute_centerline(vessel, wall, from, to);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.inscribed_radii, b.inscribed_radii);
}

template <typename Call>
void expect_refused(const Call& call, const std::string& words)
{
    try {
        call();
        FAIL() << "not refused: " << words;
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(ComputeCenterline, RefusesPointsOutsideTheLumen)
{
    const Vessel vessel = test::tube_vessel(1.8e-3, 12e-3, 48, 24);
    const WallTree wall(vessel);
    const Vec3 inside(0, 0, 6e-3), outside(5e-3, 0, 6e-3), end(0, 0, 12e-3);
    expect_refused([&] { compute_centerline(vessel, wall, outside, end); },
                   "first point (5, 0, 6) mm lies outside the lumen");
    expect_refused([&] { compute_centerline(vessel, wall, inside, Vec3(0, 0, 15e-3)); },
                   "last point (0, 0, 15) mm lies outside the lumen");
    expect_refused([&] { compute_centerline(vessel, wall, inside, inside); }, "are at one place");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_refused([&] { compute_centerline(vessel, wall, Vec3(nan, 0, 0), end); },
                   "first point (nan, 0, 0) mm lies outside");
    EXPECT_THROW(compute_centerline(vessel, wall, inside, end, {.points_per_radius = nan}),
                 InputError);
}

TEST(ComputeCenterline, RefusesPointsThatNoPathJoins)
{
    // Two tubes side by side, 6 mm apart, with all four openings in one vessel.
    Vessel pair = test::tube_vessel(1.8e-3, 12e-3, 48, 24);
    const Vessel single = pair;
    const int num_points = static_cast<int>(single.wall.points.size());
    for (const Vec3& point : single.wall.points) {
        pair.wall.points.push_back(point + Vec3(6e-3, 0, 0));
    }
    for (const auto& [a, b, c] : single.wall.triangles) {
        pair.wall.triangles.push_back({a + num_points, b + num_points, c + num_points});
    }
    for (Opening opening : single.openings) {
        opening.centre.x() += 6e-3;
        for (int& point : opening.rim)
            point += num_points;
        pair.openings.push_back(opening);
    }
    const WallTree wall(pair);
    expect_refused([&] { compute_centerline(pair, wall, Vec3(0, 0, 0), Vec3(6e-3, 0, 12e-3)); },
                   "no path through the lumen joins (0, 0, 0) mm and (6, 0, 12) mm");
}

TEST(WithInscribedRadii, FillsInWhatIsMissingOnly)
{
    const Vessel vessel = test::tube_vessel(1.8e-3, 12e-3, 48, 24);
    const WallTree wall(vessel);
    Polyline line;
    line.points = {Vec3(0, 0, 0), Vec3(0.8e-3, 0, 6e-3), Vec3(0, 0, 12e-3)};
    const Polyline filled = with_inscribed_radii(line, wall);
    ASSERT_EQ(filled.inscribed_radii.size(), 3u);
    // The prism of 48 sides lies up to 4 um inside the cylinder.
    EXPECT_NEAR(filled.inscribed_radii[1], 1.0e-3, 4e-6);

    line.inscribed_radii = {1e-3, 2e-3, 3e-3};
    EXPECT_EQ(with_inscribed_radii(line, wall).inscribed_radii, line.inscribed_radii);
}

TEST(WithInscribedRadii, RefusesPointsOutside)
{
    const Vessel vessel = test::tube_vessel(1.8e-3, 12e-3, 48, 24);
    const WallTree wall(vessel);
    Polyline line;
    line.points = {Vec3(0, 0, 0), Vec3(4e-3, 0, 6e-3), Vec3(0, 0, 9e-3), Vec3(0, 0, 13e-3)};
    expect_refused([&] { with_inscribed_radii(line, wall); },
                   "2 of the centerline's 4 points lie outside the lumen; the first is point 1 at "
                   "(4, 0, 6) mm");
}

}  // namespace
}  // namespace braidzone
