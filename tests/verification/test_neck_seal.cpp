// The device's layer of nodes parts sac and parent vessel, however the lattice lies: a flood from
// the inlet through nodes without resistance does not come into the sac.

#include "core/centerline_io.hpp"
#include "core/surface_io.hpp"
#include "deploy/deployment.hpp"
#include "deploy/neck.hpp"
#include "export/lattice_seal.hpp"
#include "porous/braid_stokes.hpp"
#include "support/devices_of_any_size.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace braidzone {
namespace {

/// The sidewall case, deployed.
struct Sidewall {
    Vessel vessel;
    ResistanceSheet sheet;
    NeckProbe neck;
    Vec3 inlet = Vec3::Zero();

    Sidewall()
    {
        const std::filesystem::path folder =
            std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases/sidewall_aneurysm";
        const LengthUnit mm;
        vessel = make_vessel(read_surface(folder / "vessel.stl", mm), mm);
        const WallTree wall(vessel);
        const Centerline centerline = resample(read_centerline(folder / "centerline.vtp", mm));
        inlet = centerline.sections.front().origin;
        const FlowDiverter device = test::pipeline(4e-3);
        const Deployment deployment = deploy(device, centerline, wall, 25e-3, {});
        neck = neck_probes(deployment, find_openings(deployment, wall)).at(0);
        sheet = make_resistance_sheet(make_braid_surface(deployment, device), BraidStokesLaw{},
                                      Fluid{});
    }
};

/// The same, turned and moved.
Sidewall moved(Sidewall sidewall, const Mat3& turn, const Vec3& shift)
{
    const auto move = [&](Vec3& point) { point = turn * point + shift; };
    for (Vec3& point : sidewall.vessel.wall.points)
        move(point);
    for (Opening& opening : sidewall.vessel.openings) {
        move(opening.centre);
        opening.normal = turn * opening.normal;
    }
    for (Vec3& point : sidewall.sheet.surface.points)
        move(point);
    for (Vec3& centre : sidewall.sheet.surface.centres)
        move(centre);
    for (Vec3& normal : sidewall.sheet.surface.normals)
        normal = turn * normal;
    move(sidewall.neck.centre);
    sidewall.neck.outwards = turn * sidewall.neck.outwards;
    move(sidewall.inlet);
    return sidewall;
}

int nearest_opening_to(const Vessel& vessel, const Vec3& point)
{
    return (vessel.openings[0].centre - point).norm() < (vessel.openings[1].centre - point).norm()
               ? 0
               : 1;
}

// A sac of 7 mm holds 168 mm^3 beyond the device (measured on the lattice of 0.1 mm, of 180 mm^3 of
// a ball): as much must be behind at every spacing and orientation, or some of it leaks.
TEST(NeckSeal, DoesNotDependOnTheLattice)
{
    const Sidewall original;
    const double ball = std::numbers::pi / 6.0 * std::pow(7e-3, 3);
    for (const double spacing : {0.1e-3, 0.14e-3, 0.2e-3}) {
        for (const double angle : {0.0, 0.4, 0.9}) {
            SCOPED_TRACE(testing::Message() << "spacing " << spacing << ", angle " << angle);
            const Mat3 turn =
                Eigen::AngleAxisd(angle, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
            const Sidewall sidewall =
                moved(original, turn, spacing * Vec3(0.37, 0.11, 0.73) * angle);
            const PorousField field =
                deposit(sidewall.sheet, sidewall.vessel, {.spacing = spacing});
            const LatticeNodes nodes = make_lattice_nodes(
                field, sidewall.vessel, nearest_opening_to(sidewall.vessel, sidewall.inlet));
            const LatticeSeal seal = lattice_seal(nodes, {sidewall.neck});
            EXPECT_EQ(seal.necks.at(0), NeckSeal::sealed);
            const double behind = static_cast<double>(seal.num_behind) * std::pow(spacing, 3);
            EXPECT_GT(behind, 0.85 * ball);
            EXPECT_LT(behind, 1.05 * ball);
        }
    }
}

}  // namespace
}  // namespace braidzone
