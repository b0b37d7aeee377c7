#include "core/error.hpp"
#include "core/surface_check.hpp"
#include "export/lattice_export.hpp"
#include "export/lattice_hemoflow.hpp"
#include "export/node_box.hpp"
#include "export/vessel_extension.hpp"
#include "support/lattices.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace braidzone {
namespace {

using ::testing::HasSubstr;

constexpr double radius = 1.5e-3, length = 6e-3, clearance = 0.3e-3;
constexpr double pi = std::numbers::pi;

/// A tube turned about x by an angle.
Vessel turned_tube(double angle)
{
    TriangleMesh mesh = test::tube(radius, length, 48, 12);
    for (Vec3& point : mesh.points)
        point = Eigen::AngleAxisd(angle, Vec3::UnitX()) * point;
    return make_vessel(mesh, LengthUnit{});
}

/// A tube along a circle of radius 6 mm about z whose openings face each other across `gap` [rad]
/// about the x axis.
Vessel open_ring(double gap)
{
    constexpr double ring_radius = 6e-3;
    TriangleMesh mesh = test::tube(radius, 1.0, 24, 60);
    for (Vec3& point : mesh.points) {
        const double angle = 0.5 * gap + (2.0 * pi - gap) * point.z();
        const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0);
        point = (ring_radius + point.x()) * outwards - point.y() * Vec3::UnitZ();
    }
    return make_vessel(mesh, LengthUnit{});
}

/// Nothing of the vessel lies beyond the planes of its openings, which lie across axes; the figures
/// of the openings are those that the new surface gives itself.
void expect_flat(const ExtendedVessel& extended, const Vessel& original)
{
    EXPECT_TRUE(is_sound(find_defects(extended.vessel.wall)));
    const Box box = bounding_box(extended.vessel.wall);
    ASSERT_EQ(extended.vessel.openings.size(), original.openings.size());
    const Vessel measured = make_vessel(extended.vessel.wall, original.unit);
    for (std::size_t i = 0; i < original.openings.size(); ++i) {
        const Opening& opening = extended.vessel.openings[i];
        Eigen::Index axis = 0;
        EXPECT_NEAR(opening.normal.cwiseAbs().maxCoeff(&axis), 1.0, 1e-12);
        const double face = opening.normal[axis] > 0.0 ? box.upper[axis] : box.lower[axis];
        for (const int point : opening.rim)
            EXPECT_NEAR(extended.vessel.wall.points[static_cast<std::size_t>(point)][axis], face,
                        1e-12);
        EXPECT_EQ(opening.rim.size(), original.openings[i].rim.size());
        const auto same = std::min_element(measured.openings.begin(), measured.openings.end(),
                                           [&](const Opening& a, const Opening& b) {
                                               return (a.centre - opening.centre).norm() <
                                                      (b.centre - opening.centre).norm();
                                           });
        EXPECT_LT((same->centre - opening.centre).norm(), 1e-6 * opening.radius);
        EXPECT_LT((same->normal - opening.normal).norm(), 1e-6);
        EXPECT_NEAR(same->area / original.openings[i].area, 1.0, 1e-4);
    }
}

TEST(ExtendOpenings, LeavesWhatIsFlat)
{
    const Vessel vessel = turned_tube(0.0);
    const ExtendedVessel extended = extend_openings(vessel, {.clearance = clearance});
    EXPECT_TRUE(extended.tubes.empty());
    EXPECT_EQ(extended.vessel.wall.points.size(), vessel.wall.points.size());
    const ExtendedVessel asked =
        extend_openings(turned_tube(0.3), {.faces = OpeningFaces::as_is, .clearance = clearance});
    EXPECT_TRUE(asked.tubes.empty());
}

// A tube's volume is its section times the way of its middle (Pappus), with its arcs in steps of
// 0.15 rad or less. Each tube: straight 0.3 mm, an arc of 2 radii, then to a plane that lies 0.6 mm
// beyond the highest point of the arc's end, or of the vessel.
TEST(ExtendOpenings, BendToTheNearestAxis)
{
    for (const double angle : {0.3, 0.7}) {
        const Vessel vessel = turned_tube(angle);
        const ExtendedVessel extended = extend_openings(vessel, {.clearance = clearance});
        expect_flat(extended, vessel);
        ASSERT_EQ(extended.tubes.size(), 2U);
        double added = 0.0;
        for (const OpeningTube& tube : extended.tubes) {
            EXPECT_NEAR(tube.turn, angle, 1e-9);
            EXPECT_NEAR(std::abs(tube.direction.z()), 1.0, 1e-12);
            EXPECT_GT(tube.length, clearance + 2.0 * radius * angle + 2.0 * clearance - 1e-9);
            added += tube.length * vessel.openings[static_cast<std::size_t>(tube.opening)].area;
        }
        const double before = enclosed_volume(close_openings(vessel).mesh);
        const double after = enclosed_volume(close_openings(extended.vessel).mesh);
        EXPECT_NEAR((after - before) / added, 1.0, 0.01);
        EXPECT_THAT(describe(extended.tubes, vessel)[0],
                    HasSubstr(angle == 0.3 ? "turned by 17 degrees" : "turned by 40 degrees"));
    }
}

// A turn of 1e-5 needs no arc, but a plane.
TEST(ExtendOpenings, FlattenAnOpeningThatIsAlmostFlat)
{
    const Vessel vessel = turned_tube(1e-5);
    const ExtendedVessel extended = extend_openings(vessel, {.clearance = clearance});
    expect_flat(extended, vessel);
    EXPECT_EQ(extended.tubes.size(), 2U);
}

// Both openings of the tube look along y; for z each turns by 90 degrees, one up and one down.
TEST(ExtendOpenings, AlongZPutsTheInletAgainstTheOutlets)
{
    const Vessel vessel = turned_tube(0.5 * pi);
    for (const int inlet : {0, 1}) {
        const ExtendedVessel extended = extend_openings(
            vessel, {.faces = OpeningFaces::extended_z, .inlet = inlet, .clearance = clearance});
        expect_flat(extended, vessel);
        const auto& openings = extended.vessel.openings;
        EXPECT_NEAR(openings[0].normal.z() * openings[1].normal.z(), -1.0, 1e-12);
    }
}

// The openings look at each other, across a chord of 8.5 mm: the tube along y would run into the
// other one's, and turns away to x or z.
TEST(ExtendOpenings, TakeTheNextAxisIfTheNearestIsBlocked)
{
    const Vessel vessel = open_ring(0.5 * pi);
    const ExtendedVessel extended = extend_openings(vessel, {.clearance = clearance});
    expect_flat(extended, vessel);
}

std::string refusal(const Vessel& vessel, OpeningFaces faces)
{
    try {
        extend_openings(vessel, {.faces = faces, .clearance = clearance});
    } catch (const GeometryError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

// A gap of 2 mm leaves no room for a bend of 3 mm.
TEST(ExtendOpenings, RefuseWhatHasNoWayOut)
{
    const Vessel vessel = open_ring(0.34);
    EXPECT_THAT(refusal(vessel, OpeningFaces::extended),
                HasSubstr("cannot be made flat: a tube from it to any face of the box would run "
                          "into the vessel"));
    EXPECT_THAT(refusal(vessel, OpeningFaces::extended_z), HasSubstr("to a face across z"));
}

TEST(ExtendOpenings, WantAClearance)
{
    EXPECT_THROW(extend_openings(turned_tube(0.3), {.clearance = 0.0}), InputError);
    EXPECT_THROW(extend_openings(turned_tube(0.3), {.clearance = std::nan("")}), InputError);
}

// What HemoFlow refuses of the turned tube it takes of the extended one: its openings are layers of
// nodes on faces. The device's field is the same: its integral, and each node's place.
TEST(ExtendOpenings, MakeALatticeThatNeedsFlatOpenings)
{
    const Vessel vessel = turned_tube(0.3);
    const Vec3 axis = Eigen::AngleAxisd(0.3, Vec3::UnitX()) * Vec3::UnitZ();
    const Vec3 across = Eigen::AngleAxisd(0.3, Vec3::UnitX()) * Vec3::UnitY();
    const BraidSurface surface =
        test::flat_braid(0.5 * length * axis - 1e-3 * (across + Vec3::UnitX()),
                         0.1e-3 * Vec3::UnitX(), 20, 0.1e-3 * across, 20, 30e-6);
    const PorousField field =
        deposit(make_resistance_sheet(surface, ConstantLaw{{400.0, 300.0}}, Fluid{}), vessel,
                {.spacing = 0.1e-3});
    const ExtendedVessel extended =
        extend_openings(vessel, {.clearance = extension_clearance(0.1e-3)});
    const LatticeNodes before = make_lattice_nodes(field, vessel, 0);
    const LatticeNodes after = make_lattice_nodes(field, extended.vessel, 0);
    EXPECT_THROW(box_between_openings(before, vessel, LatticeTarget::hemoflow), ConfigError);
    const OpeningBox box = box_between_openings(after, extended.vessel, LatticeTarget::hemoflow);
    EXPECT_EQ(box.faces[0].axis, 2);
    EXPECT_NE(box.faces[0].is_upper, box.faces[1].is_upper);
    const double exact = resistance_integral(field);
    EXPECT_NEAR(resistance_integral(after), exact, 1e-12 * exact);
    ASSERT_EQ(after.resisting.size(), before.resisting.size());
    for (std::size_t i = 0; i < after.resisting.size(); ++i) {
        const auto place = [i](const LatticeNodes& nodes) {
            const auto& [x, y, z] = place_of(nodes.grid, nodes.resisting[i]);
            return nodes.grid.centre(x, y, z);
        };
        EXPECT_LT((place(after) - place(before)).norm(), 1e-12);
    }
    // The tubes are part of the lumen: round openings of about the tube's area.
    for (const LatticeOpening& opening : after.openings)
        EXPECT_NEAR(static_cast<double>(opening.num_nodes) / (pi * 15.0 * 15.0), 1.0, 0.1);
}

}  // namespace
}  // namespace braidzone
