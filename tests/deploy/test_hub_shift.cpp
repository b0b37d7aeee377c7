#include "core/phantom_file.hpp"
#include "deploy/hub_shift.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace braidzone {

namespace {

constexpr double neck = 15e-3;  // arc length of the sac's middle [m]
constexpr double size = 0.1e-3;

/// A straight vessel of 1.9 mm with a sac along x from its middle.
PhantomVessel vessel_with_a_sac()
{
    Phantom phantom;
    phantom.segments = {{30e-3, 0.0, 0.0}};
    phantom.proximal_radius = 1.9e-3;
    phantom.distal_radius = 1.9e-3;
    phantom.edge_length = 0.3e-3;
    phantom.sacs = {
        {.position = neck, .direction = 0.0, .diameter = 6e-3, .height = 6e-3, .neck = 4e-3}};
    return make_phantom(phantom);
}

std::vector<CrossSection> sections_of(const Centerline& line, const std::vector<double>& at)
{
    std::vector<CrossSection> sections;
    for (const double arc_length : at)
        sections.push_back(section_at(line, arc_length));
    return sections;
}

/// How far hubs at some arc lengths move.
std::vector<Vec3> moves(const Vessel& vessel, const Centerline& line, double nominal_radius)
{
    std::vector<double> at;
    for (double arc_length = 5e-3; arc_length < 25e-3; arc_length += 0.25e-3)
        at.push_back(arc_length);
    const std::vector<CrossSection> before = sections_of(line, at);
    std::vector<CrossSection> rings = before;
    shift_hubs(rings, at, WallTree(vessel), nominal_radius, size);
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        EXPECT_NEAR((rings[i].origin - before[i].origin).dot(before[i].tangent), 0.0, 1e-12);
        all.push_back(rings[i].origin - before[i].origin);
    }
    return all;
}

}  // namespace

TEST(ShiftHubs, TowardsTheSacInFrontOfItsNeckOnly)
{
    const PhantomVessel made = vessel_with_a_sac();
    const Vessel vessel = make_vessel(made.wall, LengthUnit{});
    const Centerline line = resample(made.centerline);
    // The neck is open towards the normal of the axis, as `direction` has it.
    const Vec3 to_sac = section_at(line, neck).normal;
    const std::vector<Vec3> all = moves(vessel, line, 2e-3);
    const Vec3 in_front = all[40], far = all[4];  // at 15 and 6 mm
    EXPECT_NEAR(in_front.norm(), size, 0.02 * size);
    EXPECT_GT(std::abs(in_front.dot(to_sac)), 0.99 * size);
    EXPECT_LT(far.norm(), 1e-9);
    for (const Vec3& move : all)
        EXPECT_LE(move.norm(), size * (1.0 + 1e-9));
}

TEST(ShiftHubs, NotInAVesselThatHoldsThemAllAround)
{
    Polyline axis;
    for (int i = 0; i <= 30; ++i)
        axis.points.emplace_back(0.0, 0.0, i * 1e-3);
    axis.inscribed_radii.assign(axis.points.size(), 1.9e-3);
    for (const Vec3& move : moves(test::tube_vessel(1.9e-3, 30e-3, 96), resample(axis), 2e-3))
        EXPECT_EQ(move.norm(), 0.0);
}

}  // namespace braidzone
