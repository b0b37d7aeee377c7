#include "core/error.hpp"
#include "core/mesh_topology.hpp"
#include "core/surface_check.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

const LengthUnit mm{"mm", 1e-3};
constexpr double pi = std::numbers::pi;

/// Area of a regular polygon: n/2 r^2 sin(2 pi / n).
double polygon_area(double radius, int corners)
{
    return 0.5 * corners * radius * radius * std::sin(2.0 * pi / corners);
}

/// A tube whose radius grows linearly from `lower` to `upper`.
TriangleMesh cone(double lower, double upper, double length)
{
    TriangleMesh mesh = test::tube(1.0, length, 24, 20);
    for (Vec3& point : mesh.points) {
        point.head<2>() *= lower + (upper - lower) * point.z() / length;
    }
    return mesh;
}

TriangleMesh closed(TriangleMesh mesh)
{
    for (const std::vector<int>& loop : border_loops(mesh)) {
        append_fan(mesh, loop, Vec3(0, 0, mesh.points[static_cast<std::size_t>(loop[0])].z()));
    }
    return mesh;
}

/// The two triangles between rows 10 and 11 of a tube, on the side of +x, taken out.
TriangleMesh with_hole(TriangleMesh mesh, int around)
{
    const auto first = mesh.triangles.begin() + 10 * 2 * around;
    mesh.triangles.erase(first, first + 2);
    return mesh;
}

std::string message_of(const TriangleMesh& mesh, const LengthUnit& unit = mm,
                       const VesselOptions& options = {})
{
    try {
        make_vessel(mesh, unit, options);
    } catch (const GeometryError& error) {
        return error.what();
    }
    return "";
}

TEST(MakeVessel, MeasuresTheRimsOfAnOpenTube)
{
    const Vessel vessel = make_vessel(cone(2e-3, 1.5e-3, 10e-3), mm);
    ASSERT_EQ(vessel.openings.size(), 2u);
    EXPECT_TRUE(vessel.notes.empty());
    const Opening& wide = vessel.openings[0];
    const Opening& narrow = vessel.openings[1];
    EXPECT_NEAR(wide.area, polygon_area(2e-3, 24), 1e-12 * wide.area);
    EXPECT_NEAR(narrow.area, polygon_area(1.5e-3, 24), 1e-12 * wide.area);
    EXPECT_DOUBLE_EQ(wide.radius, std::sqrt(wide.area / pi));
    EXPECT_LT((wide.centre - Vec3(0, 0, 0)).norm(), 1e-15);
    EXPECT_LT((narrow.centre - Vec3(0, 0, 10e-3)).norm(), 1e-15);
    EXPECT_LT((wide.normal + Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_LT((narrow.normal - Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_EQ(wide.rim.size(), 24u);
}

TEST(MakeVessel, OrdersTheRimAnticlockwiseSeenFromOutside)
{
    const Vessel vessel = make_vessel(cone(2e-3, 1.5e-3, 10e-3), mm);
    for (const Opening& opening : vessel.openings) {
        for (std::size_t k = 0; k < opening.rim.size(); ++k) {
            const auto a = static_cast<std::size_t>(opening.rim[k]);
            const auto b = static_cast<std::size_t>(opening.rim[(k + 1) % opening.rim.size()]);
            const Vec3 from = vessel.wall.points[a] - opening.centre;
            const Vec3 to = vessel.wall.points[b] - opening.centre;
            EXPECT_GT(from.cross(to).dot(opening.normal), 0.0);
            // Neighbours on the rim are one side of the polygon apart.
            EXPECT_NEAR((to - from).norm(), 2.0 * from.norm() * std::sin(pi / 24), 1e-15);
        }
    }
}

// A rim that is dense on one side: the mean of its points is not its centroid.
TEST(MakeVessel, FindsTheCentreOfARimOfUnevenPoints)
{
    // A box of 2 x 2 x 6 mm whose edge at x = 2 mm has an additional point on either rim.
    TriangleMesh mesh;
    for (const double z : {0.0, 6e-3}) {
        mesh.points.insert(mesh.points.end(),
                           {Vec3(0, 0, z), Vec3(2e-3, 0, z), Vec3(2e-3, 0.5e-3, z),
                            Vec3(2e-3, 2e-3, z), Vec3(0, 2e-3, z)});
    }
    for (int k = 0; k < 5; ++k) {
        const int next = (k + 1) % 5;
        mesh.triangles.push_back({k, next, next + 5});
        mesh.triangles.push_back({k, next + 5, k + 5});
    }
    const Vessel vessel = make_vessel(mesh, mm);
    for (const Opening& opening : vessel.openings) {
        EXPECT_NEAR(opening.area, 4e-6, 1e-18);
        EXPECT_LT((opening.centre.head<2>() - Vec2(1e-3, 1e-3)).norm(), 1e-15);
    }
}

TEST(MakeVessel, OpensTheFlatCapsOfAClosedTube)
{
    const TriangleMesh open = cone(2e-3, 1.5e-3, 10e-3);
    const Vessel vessel = make_vessel(closed(open), mm);
    EXPECT_EQ(vessel.wall.triangles, open.triangles);
    EXPECT_EQ(vessel.wall.points, open.points);  // the caps' middle points are gone
    ASSERT_EQ(vessel.openings.size(), 2u);
    EXPECT_NEAR(vessel.openings[0].area, polygon_area(2e-3, 24), 1e-16);
    EXPECT_EQ(vessel.notes, std::vector<std::string>{"opened 2 flat caps"});
}

TEST(MakeVessel, OpensTheCapOfATubeThatIsClosedAtOneEnd)
{
    TriangleMesh mesh = cone(2e-3, 1.5e-3, 10e-3);
    append_fan(mesh, border_loops(mesh)[0], Vec3::Zero());
    const Vessel vessel = make_vessel(mesh, mm);
    EXPECT_EQ(vessel.openings.size(), 2u);
    EXPECT_EQ(vessel.notes, std::vector<std::string>{"opened 1 flat caps"});
}

TEST(MakeVessel, RefusesAClosedSurfaceWithoutFlatCaps)
{
    TriangleMesh mesh = closed(test::tube(2e-3, 10e-3, 24, 10));
    mesh.points.back().z() += 1e-3;  // two domes
    mesh.points[mesh.points.size() - 2].z() -= 1e-3;
    const std::string message = message_of(mesh);
    EXPECT_EQ(
        message.find("the surface is closed and has no flat caps (normals within 5 degrees, a "
                     "rim sharper than 45 degrees) that could be opened; its ends are\n  0: "
                     "about "),
        0u)
        << message;
    EXPECT_NE(message.find("\n  1: about "), std::string::npos) << message;
    EXPECT_EQ(message.find("\n  2: about "), std::string::npos) << message;
    EXPECT_NE(message.find("\ncut two of them open in vessel.openings, or give end points in the "
                           "lumen, vessel.from and vessel.to"),
              std::string::npos)
        << message;
}

// 24 sides on a circle of 2 mm: an area of 12.4233 mm^2, that of a circle of 3.97717 mm.
TEST(MakeVessel, RefusesASingleOpening)
{
    TriangleMesh mesh = test::tube(2e-3, 10e-3, 24, 10);
    append_fan(mesh, border_loops(mesh)[0], Vec3(0, 0, -1e-3));
    EXPECT_EQ(message_of(mesh),
              "the vessel has one opening only, of 3.97717 mm diameter at (0, 0, 10) mm; blood "
              "needs an inlet and an outlet");
}

TEST(MakeVessel, RefusesAHoleWithItsPlaceInTheUnitOfTheFile)
{
    // Two triangles of 10/20 mm by a chord of 2 * 2 mm * sin(7.5 degrees) = 0.522105 mm: area
    // 0.261052 mm^2, diameter 0.576526 mm; its middle is at the angle 7.5 degrees, on the chord.
    const TriangleMesh mesh = with_hole(test::tube(2e-3, 10e-3, 24, 20), 24);
    const std::string message = message_of(mesh);
    EXPECT_EQ(message.find("the wall has 1 opening far smaller than the lumen behind, without a "
                           "tube that leads there:\n  0.576526 mm diameter at (1.96593, 0.258819, "
                           "5.25) mm, where the lumen is 3."),
              0u)
        << message;
    EXPECT_NE(message.find("`repair = [\"holes\"]`"), std::string::npos);
}

TEST(MakeVessel, ClosesAHoleOnRequest)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 24, 20);
    const Vessel vessel = make_vessel(with_hole(tube, 24), mm, {.repair = all_repairs});
    EXPECT_EQ(vessel.openings.size(), 2u);
    EXPECT_NEAR(surface_area(vessel.wall), surface_area(tube), 1e-12 * surface_area(tube));
    ASSERT_EQ(vessel.notes.size(), 1u);
    EXPECT_EQ(vessel.notes[0],
              "closed a hole of 0.576526 mm diameter at (1.96593, 0.258819, 5.25) mm");
}

TEST(MakeVessel, TurnsAnInvertedSurfaceAndSaysSo)
{
    TriangleMesh mesh = test::tube(2e-3, 10e-3, 24, 10);
    for (auto& corners : mesh.triangles)
        std::swap(corners[0], corners[1]);
    const Vessel vessel = make_vessel(mesh, mm);
    EXPECT_EQ(vessel.notes, std::vector<std::string>{"turned all normals out of the lumen"});
    EXPECT_TRUE(is_sound(find_defects(vessel.wall)));
}

TEST(MakeVessel, RefusesDefectsByElement)
{
    TriangleMesh mesh = test::tube(2e-3, 10e-3, 24, 10);
    mesh.triangles.push_back({5, 5, 6});
    EXPECT_EQ(message_of(mesh),
              "the vessel's surface is defective:\n1 degenerate triangles: 480\n"
              "mend it, or state `repair = [\"merge\"]` in [vessel]");
}

TEST(MakeVessel, RefusesNoTriangles)
{
    EXPECT_NE(message_of(TriangleMesh{}).find("0 separate parts"), std::string::npos);
}

// A vessel in metres that was declared as millimetres is 4 micrometres wide; one in millimetres
// declared as metres, 4 m.
TEST(MakeVessel, RefusesAVesselInTheWrongUnit)
{
    EXPECT_EQ(message_of(test::tube(2e-6, 10e-6, 24, 10)),
              "the largest opening is 0.00397717 mm wide, no blood vessel (0.5 to 30 mm): is the "
              "surface really in mm? Check `length_unit` in [vessel]");
    EXPECT_NE(
        message_of(test::tube(2.0, 10.0, 24, 10), LengthUnit{"m", 1.0}).find("3977.17 mm wide"),
        std::string::npos);
}

TEST(MakeVessel, KeepsTheUnitOfTheFile)
{
    EXPECT_EQ(make_vessel(test::tube(2e-3, 10e-3, 24, 10), LengthUnit{"cm", 1e-2}).unit.name, "cm");
}

// A part of another kind of repair is not done by the way.
TEST(MakeVessel, DoesNoRepairThatIsNotNamed)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 24, 20);
    const TriangleMesh crumb = test::box(Vec3(5e-3, 0, 0), Vec3(5.1e-3, 0.2e-3, 0.2e-3));
    const TriangleMesh mesh = test::joined(with_hole(tube, 24), crumb);
    EXPECT_EQ(message_of(mesh, mm, {.repair = {.holes = true}}),
              "the vessel's surface is defective:\n2 separate parts instead of 1\n"
              "  beside the largest: a part of 12 triangles, 0.3 mm across, about (5.05, 0.1, 0.1) "
              "mm\n"
              "mend it, or state `repair = [\"holes\", \"parts\"]` in [vessel]");
    EXPECT_EQ(message_of(mesh, mm, {.repair = {.parts = true}}).find("the wall has 1 opening"), 0u);
    const Vessel vessel = make_vessel(mesh, mm, {.repair = {.holes = true, .parts = true}});
    ASSERT_EQ(vessel.notes.size(), 2u);
    EXPECT_EQ(vessel.notes[0],
              "dropped a part of 12 triangles, 0.3 mm across, about (5.05, 0.1, 0.1) mm");
    EXPECT_EQ(vessel.openings.size(), 2u);
}

// 1e-6 mm of 0.5 mm edges: the two halves of a tube do not quite meet.
TEST(MakeVessel, ClosesACrackOfRoundingAndSaysSo)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 24, 20);
    TriangleMesh mesh = tube;
    const int offset = static_cast<int>(mesh.points.size());
    for (int k = 0; k < 24; ++k)
        mesh.points.push_back(mesh.points[static_cast<std::size_t>(10 * 24 + k)] +
                              Vec3(1e-9, -1e-9, 1e-9));
    for (std::size_t k = 10 * 48; k < 11 * 48; ++k) {
        for (int& corner : mesh.triangles[k])
            corner = corner < 11 * 24 ? corner - 10 * 24 + offset : corner;
    }
    const Vessel vessel = make_vessel(mesh, mm);
    EXPECT_EQ(vessel.openings.size(), 2u);
    EXPECT_EQ(vessel.wall.triangles.size(), tube.triangles.size());
    EXPECT_EQ(vessel.notes,
              std::vector<std::string>{
                  "merged 24 points nearer to another one than 1e-4 of the edges there"});
}

// The largest opening is number 0; both are 4 and 3 mm wide.
TEST(MakeVessel, KeepsCapsAndCutsAsOrdered)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 24, 20);
    const Vec3 hole(1.96593e-3, 0.258819e-3, 5.25e-3);
    const Vessel kept =
        make_vessel(with_hole(tube, 24), mm, {.orders = {{hole, OpeningAction::keep}}});
    EXPECT_EQ(kept.openings.size(), 3u);
    const Vessel capped =
        make_vessel(with_hole(tube, 24), mm, {.orders = {{hole, OpeningAction::cap}}});
    EXPECT_EQ(capped.openings.size(), 2u);
    EXPECT_NEAR(surface_area(capped.wall), surface_area(tube), 1e-12 * surface_area(tube));
    const Vessel cut =
        make_vessel(tube, mm, {.orders = {{Vec3(0, 0, 8.25e-3), OpeningAction::cut}}});
    ASSERT_EQ(cut.openings.size(), 2u);
    EXPECT_NEAR(surface_area(cut.wall), 0.825 * surface_area(tube), 1e-9 * surface_area(tube));
    EXPECT_EQ(cut.openings[0].kind == "cut", cut.openings[0].centre.z() > 5e-3);
    EXPECT_NE(cut.openings[0].kind, cut.openings[1].kind);
}

// A capsule: its two ends are numbers 0 and 1, as nothing is open.
TEST(MakeVessel, CutsTheRoundedEndsThatAreOrdered)
{
    const Vessel vessel =
        make_vessel(test::capsule(2e-3, 12e-3, 48, 48), mm,
                    {.orders = {{0, OpeningAction::cut}, {1, OpeningAction::cut}}});
    ASSERT_EQ(vessel.openings.size(), 2u);
    for (const Opening& opening : vessel.openings) {
        EXPECT_EQ(opening.kind, "cut");
        EXPECT_NEAR(opening.radius, 2e-3, 0.02e-3);
    }
    // A prism of 12 mm, up to the width of the bands that find the ends' middles.
    EXPECT_NEAR(surface_area(vessel.wall), 2.0 * pi * 2e-3 * 12e-3, 0.1 * 2.0 * pi * 2e-3 * 12e-3);
}

TEST(MakeVessel, RefusesOrdersThatNameNothing)
{
    const TriangleMesh tube = test::tube(2e-3, 10e-3, 24, 20);
    EXPECT_EQ(message_of(tube, mm, {.orders = {{2, OpeningAction::cap}}}),
              "vessel.openings names opening 2; the vessel has 2 that could be kept or capped");
    EXPECT_EQ(message_of(tube, mm, {.orders = {{Vec3(9e-3, 0, 0), OpeningAction::keep}}}),
              "vessel.openings names (9, 0, 0) mm, but no opening lies there: a point names an "
              "opening whose middle is nearer to it than the opening is wide");
    EXPECT_EQ(message_of(tube, mm, {.orders = {{5, OpeningAction::cut}}}),
              "vessel.openings cuts at 5; the vessel has 2 openings and 0 rounded ends");
    EXPECT_EQ(message_of(tube, mm, {.orders = {{Vec3(9e-3, 0, 0), OpeningAction::cut}}}),
              "vessel.openings cuts at (9, 0, 0) mm, which is not in the lumen");
}

// A line along a capsule from 1 mm to 11 mm of its 12 mm cylinder, and one from tip to tip.
TEST(MakeVessel, CutsAClosedSurfaceWhereALineEnds)
{
    const TriangleMesh surface = test::capsule(2e-3, 12e-3, 48, 48);
    const std::vector<Vec3> line{Vec3(0, 0, 1e-3), Vec3(0, 0, 6e-3), Vec3(0, 0, 11e-3)};
    const Vessel vessel = make_vessel(surface, mm, {.lines = {line}});
    ASSERT_EQ(vessel.openings.size(), 2u);
    EXPECT_NEAR(surface_area(vessel.wall), 2.0 * pi * 2e-3 * 10e-3, 0.01 * 2.0 * pi * 2e-3 * 10e-3);
    const std::vector<Vec3> whole{Vec3(0, 0, -2e-3), Vec3(0, 0, 6e-3), Vec3(0, 0, 14e-3)};
    EXPECT_EQ(make_vessel(surface, mm, {.lines = {whole}}).openings.size(), 2u);
    // An open vessel is not cut where a line ends within it.
    const TriangleMesh tube = test::tube(2e-3, 20e-3, 24, 20);
    const std::vector<Vec3> part{Vec3(0, 0, 8e-3), Vec3(0, 0, 10e-3), Vec3(0, 0, 12e-3)};
    EXPECT_EQ(make_vessel(tube, mm, {.lines = {part}}).wall.points, tube.points);
}

TEST(CloseOpenings, FansEachOpeningAfterTheWall)
{
    const Vessel vessel = make_vessel(cone(2e-3, 1.5e-3, 10e-3), mm);
    const ClosedLumen lumen = close_openings(vessel);
    const std::size_t num_wall = vessel.wall.triangles.size();
    ASSERT_EQ(lumen.mesh.triangles.size(), num_wall + 48);
    ASSERT_EQ(lumen.opening_of.size(), num_wall + 48);
    for (std::size_t k = 0; k < lumen.opening_of.size(); ++k) {
        const int expected = k < num_wall ? -1 : k < num_wall + 24 ? 0 : 1;
        EXPECT_EQ(lumen.opening_of[k], expected);
        if (k < num_wall) {
            EXPECT_EQ(lumen.mesh.triangles[k], vessel.wall.triangles[k]);
        }
    }
    EXPECT_TRUE(is_sound(find_defects(lumen.mesh)));
}

// A frustum between polygons of areas A and B: h/3 (A + sqrt(A B) + B). Its sides are plane,
// so the triangulated wall encloses it exactly.
TEST(CloseOpenings, EnclosesTheVolumeOfTheFrustum)
{
    const Vessel vessel = make_vessel(cone(2e-3, 1.5e-3, 10e-3), mm);
    const double a = polygon_area(2e-3, 24), b = polygon_area(1.5e-3, 24);
    const double expected = 10e-3 / 3.0 * (a + std::sqrt(a * b) + b);
    EXPECT_NEAR(enclosed_volume(close_openings(vessel).mesh), expected, 1e-12 * expected);
}

}  // namespace
}  // namespace braidzone
