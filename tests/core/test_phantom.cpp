#include "core/centerline_io.hpp"
#include "core/error.hpp"
#include "core/phantom.hpp"
#include "core/phantom_file.hpp"
#include "core/phantom_shape.hpp"
#include "core/surface_check.hpp"
#include "core/surface_io.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

namespace braidzone {
namespace {

constexpr double pi = std::numbers::pi;
const LengthUnit mm{"mm", 1e-3};

Phantom straight(double radius = 2e-3, double length = 12e-3)
{
    Phantom phantom;
    phantom.segments = {{.length = length}};
    phantom.proximal_radius = radius;
    phantom.distal_radius = radius;
    return phantom;
}

Phantom with_sac(double neck = 4.5e-3)
{
    Phantom phantom = straight(2e-3, 16e-3);
    phantom.sacs = {{.position = 8e-3, .diameter = 7e-3, .height = 7e-3, .neck = neck}};
    return phantom;
}

/// Smallest corner angle [rad].
double smallest_angle(const TriangleMesh& mesh)
{
    double smallest = pi;
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto point = [&](std::size_t k) {
                return mesh.points[static_cast<std::size_t>(triangle[(corner + k) % 3])];
            };
            const Vec3 a = (point(1) - point(0)).normalized();
            const Vec3 b = (point(2) - point(0)).normalized();
            smallest = std::min(smallest, std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
        }
    }
    return smallest;
}

const Opening& opening_near(const Vessel& vessel, const Vec3& place)
{
    return *std::min_element(vessel.openings.begin(), vessel.openings.end(),
                             [&](const Opening& a, const Opening& b) {
                                 return (a.centre - place).norm() < (b.centre - place).norm();
                             });
}

TEST(MakePhantom, PointsOfAStraightTubeLieOnItsCylinder)
{
    const PhantomVessel vessel = make_phantom(straight());
    for (const Vec3& point : vessel.wall.points) {
        EXPECT_NEAR(std::hypot(point.y(), point.z()), 2e-3, 1e-9);
        EXPECT_GE(point.x(), -1e-12);
        EXPECT_LE(point.x(), 12e-3 + 1e-12);
    }
}

// Triangles of edge h on a cylinder of radius r lose (h / r)^2 / 12 or so of the volume: 0.3 %.
TEST(MakePhantom, EnclosesTheVolumeOfItsTube)
{
    const Vessel vessel = make_vessel(make_phantom(straight()).wall, mm);
    const double exact = pi * 2e-3 * 2e-3 * 12e-3;
    const double volume = enclosed_volume(close_openings(vessel).mesh);
    EXPECT_GT(volume, 0.99 * exact);
    EXPECT_LT(volume, exact);
}

TEST(MakePhantom, EndsAreFlatCirclesAcrossTheAxis)
{
    Phantom phantom = straight();
    phantom.distal_radius = 1.7e-3;
    const Vessel vessel = make_vessel(make_phantom(phantom).wall, mm);
    ASSERT_EQ(vessel.openings.size(), 2u);
    for (const double x : {0.0, 12e-3}) {
        const Opening& opening = opening_near(vessel, Vec3(x, 0, 0));
        const double radius = x == 0.0 ? 2e-3 : 1.7e-3;
        EXPECT_NEAR(std::abs(opening.normal.x()), 1.0, 1e-9);
        for (const int index : opening.rim) {
            const Vec3& point = vessel.wall.points[static_cast<std::size_t>(index)];
            EXPECT_NEAR(point.x(), x, 1e-9);
            EXPECT_NEAR(std::hypot(point.y(), point.z()), radius, 1e-9);
        }
    }
}

TEST(MakePhantom, TapersLinearly)
{
    Phantom phantom = straight();
    phantom.distal_radius = 1.4e-3;
    for (const Vec3& point : make_phantom(phantom).wall.points) {
        EXPECT_NEAR(std::hypot(point.y(), point.z()), 2e-3 - 0.6e-3 * point.x() / 12e-3, 1e-9);
    }
}

// Half axes r / sqrt(0.64) = 1.25 r along z and r sqrt(0.64) = 0.8 r along y.
TEST(MakePhantom, OvalSectionIsAnEllipseOfTheSameArea)
{
    Phantom phantom = straight();
    phantom.ovality = 0.64;
    phantom.oval_direction = 0.5 * pi;
    const PhantomVessel made = make_phantom(phantom);
    for (const Vec3& point : made.wall.points) {
        EXPECT_NEAR(std::hypot(point.y() / 1.6e-3, point.z() / 2.5e-3), 1.0, 1e-6);
    }
    for (const double radius : made.centerline.inscribed_radii)
        EXPECT_NEAR(radius, 1.6e-3, 1e-12);
    const Vessel vessel = make_vessel(made.wall, mm);
    EXPECT_EQ(vessel.openings.size(), 2u);
    const double exact = pi * 2e-3 * 2e-3 * 12e-3;
    const double volume = enclosed_volume(close_openings(vessel).mesh);
    EXPECT_GT(volume, 0.99 * exact);
    EXPECT_LT(volume, exact);
}

// Points between the ends of a bend of radius R about (0, R, 0) lie on a torus.
TEST(MakePhantom, BendIsATorus)
{
    const double bend = 8e-3, radius = 1.8e-3;
    Phantom phantom;
    phantom.segments = {{.length = 0.5 * pi * bend, .angle = 0.5 * pi}};
    phantom.proximal_radius = phantom.distal_radius = radius;
    const PhantomVessel vessel = make_phantom(phantom);
    for (const Vec3& point : vessel.wall.points) {
        const double in_plane = std::hypot(point.x(), point.y() - bend);
        EXPECT_NEAR(std::hypot(in_plane - bend, point.z()), radius, 1e-9);
    }
    EXPECT_NEAR((vessel.centerline.points.back() - Vec3(bend, bend, 0)).norm(), 0.0, 1e-12);
}

// Two quarter turns of radius R: an S in the plane ends at (2R, 2R, 0) along x; with the second
// turn out of the plane it ends at (R, R, 0) + (0, R, R) along z.
TEST(MakeAxis, PlaneAnglesTurnTheBends)
{
    const double bend = 8e-3;
    const double quarter = 0.5 * pi * bend;
    const auto end = [&](double plane_angle) {
        const PhantomAxis axis =
            make_axis({{.length = quarter, .angle = 0.5 * pi},
                       {.length = quarter, .angle = 0.5 * pi, .plane_angle = plane_angle}});
        return section_along(axis, axis.length);
    };
    EXPECT_NEAR((end(pi).origin - Vec3(2 * bend, 2 * bend, 0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((end(pi).tangent - Vec3::UnitX()).norm(), 0.0, 1e-12);
    EXPECT_NEAR((end(0.5 * pi).origin - Vec3(bend, 2 * bend, bend)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((end(0.5 * pi).tangent - Vec3::UnitZ()).norm(), 0.0, 1e-12);
}

TEST(MakePhantom, TrianglesAreSoundAndNearlyEquilateral)
{
    const TriangleMesh wall = make_phantom(with_sac()).wall;
    EXPECT_TRUE(is_sound(find_defects(wall))) << describe(find_defects(wall));
    EXPECT_GT(smallest_angle(wall), 20.0 * pi / 180.0);
    // An equilateral triangle of edge h has the area sqrt(3) / 4 h^2.
    const double mean_area = surface_area(wall) / static_cast<double>(wall.triangles.size());
    EXPECT_NEAR(std::sqrt(4.0 / std::sqrt(3.0) * mean_area), 0.4e-3, 0.1 * 0.4e-3);
}

// From the first grid's contour a fold is left near the distal end of this one, 28 mm down a bend,
// in which five triangles cross.
TEST(MakePhantom, BeginsAnewWhereTrianglesCross)
{
    Phantom phantom;
    phantom.segments = {
        {.length = 8e-3}, {.length = 14e-3, .angle = 0.3960780434}, {.length = 8e-3}};
    phantom.proximal_radius = 1.903826463e-3;
    phantom.distal_radius = 1.901335033e-3;
    phantom.blend_radius = 0.4e-3;
    phantom.sacs = {{.position = 15.60743111e-3,
                     .direction = pi,
                     .diameter = 7e-3,
                     .height = 7e-3,
                     .neck = 4.285675509e-3}};
    const TriangleMesh wall = make_phantom(phantom).wall;
    EXPECT_TRUE(is_sound(find_defects(wall))) << describe(find_defects(wall));
    EXPECT_GT(smallest_angle(wall), 20.0 * pi / 180.0);
}

// Sphere of 3.5 mm whose circle of 4.5 mm lies in the wall's highest line, 2 mm above the axis: its
// centre is sqrt(3.5^2 - 2.25^2) = 2.681 mm above that line.
TEST(MakePhantom, SacIsASphereOnItsNeck)
{
    const TriangleMesh wall = make_phantom(with_sac()).wall;
    const Vec3 centre(8e-3, 2e-3 + std::sqrt(3.5e-3 * 3.5e-3 - 2.25e-3 * 2.25e-3), 0.0);
    double highest = 0.0;
    for (const Vec3& point : wall.points) {
        highest = std::max(highest, point.y());
        if (point.y() < 2.7e-3) continue;  // parent vessel and fillet
        EXPECT_NEAR((point - centre).norm(), 3.5e-3, 1e-9);
    }
    EXPECT_NEAR(highest, 8.181e-3, 0.02e-3);
}

// Where sac and parent vessel meet upstream and downstream, both have their zero; on a bend, where
// the sac lies on the outer side, at equal heights too, by symmetry.
TEST(MakePhantom, NeckHasTheGivenDiameter)
{
    for (const double neck : {1e-3, 4.5e-3, 6e-3}) {
        const PhantomShape shape = make_shape(with_sac(neck));
        for (const double side : {-0.5, 0.5}) {
            const Vec3 edge(8e-3 + side * neck, 2e-3, 0.0);
            EXPECT_NEAR(shape.parts[0].level(edge), 0.0, 1e-9);
            EXPECT_NEAR(shape.parts[1].level(edge), 0.0, 1e-9);
        }
    }
    Phantom bent = with_sac();
    bent.segments[0].angle = 1.0;
    bent.sacs[0].direction = pi;
    const PhantomShape shape = make_shape(bent);
    const CrossSection middle = section_along(shape.axis, 8e-3);
    // The outer wall is a circle of 16 + 2 mm about the bend's centre; a chord of 4.5 mm of it is
    // sqrt(18^2 - 2.25^2) = 17.859 mm from there.
    const Vec3 edge = middle.origin - 1.859e-3 * middle.normal + 2.25e-3 * middle.tangent;
    EXPECT_NEAR(shape.parts[0].level(edge), 0.0, 1e-6);
    EXPECT_NEAR(shape.parts[1].level(edge), 0.0, 1e-6);
}

TEST(MakePhantom, EllipsoidalSacHasItsHeight)
{
    Phantom phantom = with_sac();
    phantom.sacs[0].height = 10e-3;
    phantom.sacs[0].direction = 0.5 * pi;
    double highest = 0.0;
    for (const Vec3& point : make_phantom(phantom).wall.points) {
        highest = std::max(highest, point.z());
    }
    // By hand: the neck's plane is 5 sqrt(1 - (4.5 / 7)^2) = 3.830 mm below the centre.
    EXPECT_NEAR(highest, 2e-3 + 3.830e-3 + 5e-3, 0.03e-3);
}

TEST(MakePhantom, DomeHasItsOwnEdgeLength)
{
    Phantom phantom = with_sac();
    const std::size_t fine = make_phantom(phantom).wall.triangles.size();
    phantom.sacs[0].edge_length = 0.8e-3;
    const TriangleMesh wall = make_phantom(phantom).wall;
    EXPECT_TRUE(is_sound(find_defects(wall)));
    EXPECT_LT(wall.triangles.size(), fine);
    double longest = 0.0, longest_on_parent = 0.0;
    for (const auto& [a, b, c] : wall.triangles) {
        const Vec3& from = wall.points[static_cast<std::size_t>(a)];
        const double edge = (wall.points[static_cast<std::size_t>(b)] - from).norm();
        double& entry = from.y() > 2e-3 ? longest : longest_on_parent;
        entry = std::max(entry, edge);
    }
    EXPECT_GT(longest, 0.8e-3);
    EXPECT_LT(longest_on_parent, 0.6e-3);
}

TEST(MakePhantom, BranchOpensWhereItEnds)
{
    Phantom phantom = straight();
    phantom.branches = {{.position = 5e-3,
                         .direction = 0.5 * pi,
                         .tilt = pi / 3.0,
                         .radius = 0.9e-3,
                         .length = 7e-3}};
    const Vessel vessel = make_vessel(make_phantom(phantom).wall, mm);
    ASSERT_EQ(vessel.openings.size(), 3u);
    // 60 degrees from the axis towards z: direction (1/2, 0, sqrt(3)/2).
    const Vec3 along(0.5, 0.0, std::sqrt(3.0) / 2.0);
    const Vec3 end = Vec3(5e-3, 0, 0) + 7e-3 * along;
    const Opening& opening = opening_near(vessel, end);
    EXPECT_NEAR((opening.centre - end).norm(), 0.0, 0.02e-3);
    EXPECT_NEAR(opening.radius, 0.9e-3, 0.03 * 0.9e-3);
    EXPECT_NEAR(opening.normal.dot(along), 1.0, 1e-6);
}

TEST(MakePhantom, BifurcationWithApexSac)
{
    Phantom phantom = straight(1.8e-3, 10e-3);
    phantom.bifurcation = PhantomBifurcation{.radius = 1.3e-3, .length = 9e-3};
    phantom.sacs = {{.position = {}, .diameter = 6e-3, .height = 7e-3, .neck = 3.5e-3}};
    const PhantomVessel made = make_phantom(phantom);
    EXPECT_TRUE(is_sound(find_defects(made.wall))) << describe(find_defects(made.wall));
    const Vessel vessel = make_vessel(made.wall, mm);
    ASSERT_EQ(vessel.openings.size(), 3u);
    const double aside = 9e-3 / std::sqrt(2.0);
    for (const double side : {1.0, -1.0}) {
        const Vec3 end(10e-3 + aside, side * aside, 0.0);
        EXPECT_NEAR((opening_near(vessel, end).centre - end).norm(), 0.0, 0.02e-3);
    }
    EXPECT_NEAR((made.centerline.points.back() - Vec3(10e-3 + aside, aside, 0)).norm(), 0.0, 1e-12);

    // By hand: the daughters' upper walls are 1.75 mm aside at 1.75 + 1.3 sqrt(2) = 3.588 mm above
    // the apex; there the ellipsoid is 3.5 sqrt(1 - (3.5 / 6)^2) = 2.843 mm below its centre.
    double farthest = 0.0;
    for (const Vec3& point : made.wall.points) {
        if (std::abs(point.y()) < 0.5e-3) farthest = std::max(farthest, point.x());
    }
    EXPECT_NEAR(farthest, 10e-3 + 3.588e-3 + 2.843e-3 + 3.5e-3, 0.04e-3);
}

// The rounded corner keeps the radii true: what is written never reaches past the wall.
TEST(MakePhantom, CenterlineRadiiAreThoseOfTheInscribedSpheres)
{
    Phantom phantom = straight(1.8e-3, 10e-3);
    phantom.bifurcation = PhantomBifurcation{.radius = 1.3e-3, .length = 9e-3};
    const PhantomVessel made = make_phantom(phantom);
    const WallTree wall(make_vessel(made.wall, mm));
    for (std::size_t i = 0; i < made.centerline.points.size(); ++i) {
        // The flat triangles run (h / r)^2 / 6 of r or so inside the round wall, 1.6 %.
        EXPECT_GT(wall.nearest(made.centerline.points[i]).distance,
                  0.98 * made.centerline.inscribed_radii[i]);
    }
}

TEST(MakePhantom, IsTheSameForAnyNumberOfThreads)
{
    const PhantomVessel many = make_phantom(with_sac());
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const PhantomVessel one = make_phantom(with_sac());
    EXPECT_EQ(many.wall.points, one.wall.points);
    EXPECT_EQ(many.wall.triangles, one.wall.triangles);
}

struct Refusal {
    std::string message;
    std::function<void(Phantom&)> change;
};

class MakePhantomRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(MakePhantomRefuses, WithAMessage)
{
    Phantom phantom = with_sac();
    GetParam().change(phantom);
    try {
        make_phantom(phantom);
        FAIL() << "not refused: " << GetParam().message;
    } catch (const ConfigError& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos)
            << error.what();
    }
}

const double nan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Parameters, MakePhantomRefuses,
    testing::Values(
        Refusal{"the phantom has no segment", [](Phantom& p) { p.segments.clear(); }},
        Refusal{"proximal radius = nan mm; it must be positive",
                [](Phantom& p) { p.proximal_radius = nan; }},
        Refusal{"distal radius = -1 mm", [](Phantom& p) { p.distal_radius = -1e-3; }},
        Refusal{"blend radius = 0 mm", [](Phantom& p) { p.blend_radius = 0.0; }},
        Refusal{"edge length = 2.5 mm; at most the smallest radius",
                [](Phantom& p) { p.edge_length = 2.5e-3; }},
        Refusal{"ovality = 0.4; allowed are 0.5 to 1", [](Phantom& p) { p.ovality = 0.4; }},
        Refusal{"ovality = nan", [](Phantom& p) { p.ovality = nan; }},
        Refusal{"oval direction = 400 deg",
                [](Phantom& p) { p.oval_direction = 400.0 * pi / 180.0; }},
        Refusal{"a bend of radius 2.4 mm; it must exceed the vessel's radius, 2.5 mm",
                [](Phantom& p) {
                    p.ovality = 0.64;
                    p.segments = {{.length = 2.4e-3, .angle = 1.0}};
                }},
        Refusal{"segment 1: length = 0 mm", [](Phantom& p) { p.segments[0].length = 0.0; }},
        Refusal{"segment 1: angle = nan deg", [](Phantom& p) { p.segments[0].angle = nan; }},
        Refusal{"a bend of radius 1.6 mm; it must exceed the vessel's radius, 2 mm",
                [](Phantom& p) { p.segments = {{.length = 1.6e-3, .angle = 1.0}}; }},
        Refusal{"sac 1: neck = 7 mm; it must be narrower than the sac, 7 mm",
                [](Phantom& p) { p.sacs[0].neck = 7e-3; }},
        Refusal{"sac 1: diameter = 0 mm", [](Phantom& p) { p.sacs[0].diameter = 0.0; }},
        Refusal{"sac 1: height = nan mm", [](Phantom& p) { p.sacs[0].height = nan; }},
        Refusal{"sac 1: position = 17 mm; allowed are 0 to 16 mm",
                [](Phantom& p) { p.sacs[0].position = 17e-3; }},
        Refusal{"sac 1: position is missing; only at a bifurcation",
                [](Phantom& p) { p.sacs[0].position.reset(); }},
        Refusal{"sac 1: edge length = 2 mm", [](Phantom& p) { p.sacs[0].edge_length = 2e-3; }},
        Refusal{"sac 1 reaches the opening of parent vessel",
                [](Phantom& p) { p.sacs[0].position = 2e-3; }},
        Refusal{"branch 1: radius = 2.1 mm; at most that of the parent vessel there, 2 mm",
                [](Phantom& p) {
                    p.branches = {{.position = 3e-3, .radius = 2.1e-3, .length = 9e-3}};
                }},
        Refusal{"branch 1: tilt = 5 deg; allowed are 10 to 170 deg",
                [](Phantom& p) {
                    p.branches = {
                        {.position = 3e-3, .tilt = pi / 36, .radius = 1e-3, .length = 9e-3}};
                }},
        Refusal{"parent vessel reaches the opening of branch 1",
                [](Phantom& p) {
                    p.branches = {
                        {.position = 3e-3, .direction = pi, .radius = 1e-3, .length = 2e-3}};
                }},
        Refusal{"bifurcation: half angle = 5 deg",
                [](Phantom& p) {
                    p.bifurcation = PhantomBifurcation{1e-3, 9e-3, pi / 36};
                }},
        Refusal{"bifurcation: radius = 2.1 mm",
                [](Phantom& p) {
                    p.bifurcation = PhantomBifurcation{2.1e-3, 9e-3};
                }},
        Refusal{"do not make one vessel with separate ends",
                // A full turn within a plane runs into itself.
                [](Phantom& p) {
                    p.sacs.clear();
                    p.segments = {{.length = 8e-3},
                                  {.length = 2 * pi * 8e-3, .angle = 2 * pi},
                                  {.length = 8e-3}};
                }}));

class ShippedCase : public testing::TestWithParam<const char*> {
protected:
    std::filesystem::path folder() const
    {
        return std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases" / GetParam();
    }
};

// The files in the repository are those of their phantom.toml: every point lies on the wall that it
// describes (to the single precision of STL), and the centerline is its axis.
TEST_P(ShippedCase, SurfaceIsThatOfItsParameters)
{
    const Phantom phantom = read_phantom(TomlTable::read_file(folder() / "phantom.toml"));
    const PhantomShape shape = make_shape(phantom);
    const TriangleMesh surface = read_surface(folder() / "vessel.stl", mm);
    for (const Vec3& point : surface.points)
        EXPECT_NEAR(level(shape, point), 0.0, 1e-8);
    EXPECT_TRUE(is_sound(find_defects(surface))) << describe(find_defects(surface));
    const Vessel vessel = make_vessel(surface, mm);
    EXPECT_EQ(vessel.openings.size(), shape.ends.size());
    for (const PhantomEnd& end : shape.ends) {
        const Opening& opening = opening_near(vessel, end.centre);
        EXPECT_NEAR((opening.centre - end.centre).norm(), 0.0, 0.01 * end.radius);
        EXPECT_NEAR(opening.radius, end.radius, 0.01 * end.radius);
    }
    const Polyline axis = read_centerline(folder() / "centerline.vtp", mm);
    const double intervals = static_cast<double>(axis.points.size() - 1);
    for (std::size_t i = 0; i < axis.points.size(); ++i) {
        const double arc_length = shape.axis.length * static_cast<double>(i) / intervals;
        const Vec3 expected = section_along(shape.axis, arc_length).origin;
        EXPECT_NEAR((axis.points[i] - expected).norm(), 0.0, 1e-12);
    }
}

// A device of 2 mm radius needs bends of more than 1.8 times its radius, or its rings would cross.
TEST_P(ShippedCase, BendsLeaveRoomForTheDevice)
{
    const Phantom phantom = read_phantom(TomlTable::read_file(folder() / "phantom.toml"));
    for (const PhantomSegment& segment : phantom.segments) {
        EXPECT_GT(segment.length, 3.6e-3 * segment.angle);
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, ShippedCase,
                         testing::Values("straight_tube", "curved_tube", "sidewall_aneurysm",
                                         "tortuous", "giant"));

}  // namespace
}  // namespace braidzone
