// The mechanics of the generator of hidden measurements (support/hidden), against hand calculation
// and against the deployment under test, with which it shares next to nothing.

#include "deploy/braid_kinematics.hpp"
#include "discrepancy/discrepancy_field.hpp"
#include "support/devices.hpp"
#include "support/hidden/hidden_case.hpp"
#include "support/hidden/sliding_rings.hpp"
#include "support/hidden/spacing_stretch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone::hidden {
namespace {

constexpr double wire_radius = 15e-6;

/// A 20 mm device in the middle of a straight vessel.
HiddenScene straight_scene(double vessel_radius)
{
    HiddenScene scene;
    scene.phantom.segments = {{60e-3, 0.0, 0.0}};
    scene.phantom.proximal_radius = vessel_radius;
    scene.phantom.distal_radius = vessel_radius;
    scene.device = test::pipeline_4x20();
    scene.landing = 40e-3;
    return scene;
}

/// Largest difference of the radii from a value, leaving out some rows at the ends.
double largest_difference(const HiddenDevice& device, double radius, int end_rows)
{
    double largest = 0.0;
    for (int i = end_rows * device.columns; i < (device.rows - end_rows) * device.columns; ++i) {
        largest = std::max(largest, std::abs(device.radii[static_cast<std::size_t>(i)] - radius));
    }
    return largest;
}

/// A crumpled piece of sheet in a wall of its own, to differentiate its energy.
struct CrumpledSheet {
    BraidSheet sheet = sheet_of(test::pipeline_4x20());
    SheetPlace place;
    std::vector<double> radii;

    CrumpledSheet()
    {
        place.rows = 6;
        place.columns = 9;
        sheet.length = 1.2e-3;
        for (int row = 0; row < place.rows; ++row) {
            CrossSection section;
            section.origin = Vec3(-0.2e-3 * row, 0.02e-3 * row * row, 0.0);
            place.sections.push_back(section);
            place.pitch.push_back(1.0 + 0.02 * row);
            for (int column = 0; column < place.columns; ++column) {
                place.angles.push_back(2.0 * std::numbers::pi * column / place.columns +
                                       0.05 * row);
                place.loads.push_back(10.0 * row - 20.0);
                radii.push_back(1.9e-3 + 0.05e-3 * std::sin(3.0 * row + 5.0 * column));
            }
        }
        place.wall = [](int, const Vec3& p) { return std::hypot(p.y(), p.z()) - 1.9e-3; };
        place.springs.stiffness = 1e6;
        place.springs.stiffening = 1e14;
    }
};

/// Gaps of the patches between the generator's device and the deployment under test.
struct Difference {
    std::size_t num_patches = 0;
    double rms = 0.0, largest = 0.0;  ///< [m]
};

Difference difference_where_nothing_is_hidden(const Belief& belief)
{
    const HiddenDevice device = placed_device(story_of(belief).scene);
    PhantomVessel made = make_phantom(belief.phantom);
    const Vessel vessel = make_vessel(made.wall, LengthUnit{});
    const WallTree wall(vessel);
    Deployment deployment =
        deploy(belief.device, resample(made.centerline), wall, belief.landing, {});
    DeviceSurface surface(deployment);
    const Simulation simulation{std::move(deployment), std::move(surface)};
    const DiscrepancyField field = make_discrepancy_field(device.points, {}, simulation);
    Difference difference{.num_patches = field.patches.size()};
    for (const Patch& patch : field.patches) {
        difference.rms += patch.gap * patch.gap / static_cast<double>(field.patches.size());
        difference.largest = std::max(difference.largest, std::abs(patch.gap));
    }
    difference.rms = std::sqrt(difference.rms);
    return difference;
}

}  // namespace

// Central differences of 10 nm; wall springs are rounded over 2 um.
TEST(HiddenDevice, FeelsTheGradientOfItsEnergy)
{
    const CrumpledSheet crumpled;
    const SheetEnergy at = sheet_energy(crumpled.sheet, crumpled.place, crumpled.radii);
    double largest = 0.0;
    for (const double part : at.gradient)
        largest = std::max(largest, std::abs(part));
    constexpr double step = 10e-9;
    for (std::size_t i = 0; i < crumpled.radii.size(); ++i) {
        std::vector<double> out = crumpled.radii, in = crumpled.radii;
        out[i] += step;
        in[i] -= step;
        const double slope = (sheet_energy(crumpled.sheet, crumpled.place, out).value -
                              sheet_energy(crumpled.sheet, crumpled.place, in).value) /
                             (2.0 * step);
        EXPECT_NEAR(at.gradient[i], slope, 1e-4 * largest) << i;
    }
}

TEST(HiddenDevice, LiesFreeAtItsNominalRadius)
{
    const HiddenDevice device = placed_device(straight_scene(2.3e-3));
    EXPECT_LT(largest_difference(device, 2e-3, 0), 0.5e-6);
    EXPECT_LT(*std::max_element(device.pressure.begin(), device.pressure.end()), 1.0);
}

// An elastic tube in a rigid one: with wires stretched by l(r), l^2 = sin^2 b + cos^2 b (r / R0)^2,
// it presses with  2 K (1 - l) cos^2 b r / (R0^2 l) + k (R0 - r)  for each force-free area.
TEST(HiddenDevice, PressesOnARigidTubeAsByHand)
{
    const HiddenScene scene = straight_scene(1.9e-3);
    const HiddenDevice device = placed_device(scene);
    const double radius = 1.9e-3 - wire_radius, nominal = 2e-3;
    // Half a micrometre of yield, as little of chords.
    EXPECT_LT(largest_difference(device, radius, 0), 1.5e-6);

    const double tangent = 0.4, square_cosine = 1.0 / (1.0 + tangent * tangent);
    const double ratio = radius / nominal;
    const double length = std::sqrt(1.0 - square_cosine + square_cosine * ratio * ratio);
    const double wires = 0.6 * (1.0 + tangent * tangent) / (2.0 * tangent);
    const double springs = 0.1 / scene.device.reference_node_area;
    const double by_hand =
        2.0 * wires * (1.0 - length) * square_cosine * radius / (nominal * nominal * length) +
        springs * (nominal - radius);
    const auto middle = static_cast<std::size_t>(device.rows / 2 * device.columns);
    EXPECT_NEAR(device.pressure[middle], by_hand, 0.02 * by_hand);
}

// Wires alone take the radius of the braid's kinematics: 2.137 mm at a spacing of 0.34 for t = 0.4
// (Zavodszky et al. 2020, Table 3: 2.13 mm).
TEST(HiddenDevice, WidensWherePushedAsTheBraidDoes)
{
    HiddenScene scene = straight_scene(2.6e-3);
    scene.device.radial_coefficient = 1e-6;
    scene.spacing = [](double) { return 0.34; };
    const HiddenDevice device = placed_device(scene);
    EXPECT_LT(largest_difference(device, 2.137e-3, 20), 1e-6);
}

// ds / dx = -(a + b s)  is solved by an exponential.
TEST(HiddenDevice, LaysItsRowsDownByTheSpacing)
{
    HiddenScene scene = straight_scene(1.9e-3);
    constexpr double a = 0.2, b = 20.0;
    scene.spacing = [=](double s) { return a + b * s; };
    const std::vector<double> rows = released_rows(scene, 20e-3, 101);
    for (int i = 0; i <= 100; i += 10) {
        const double exact = (scene.landing + a / b) * std::exp(-b * 0.2e-3 * i) - a / b;
        EXPECT_NEAR(rows[static_cast<std::size_t>(i)], exact, 1e-9);
    }
}

TEST(HiddenDevice, IsPushedOverAStretch)
{
    const SpacingStretch stretch{
        .centre = 15e-3, .half_width = 2e-3, .change = -0.6, .ripple = 0.0, .rebound = 0.1};
    EXPECT_NEAR(spacing_change(stretch, 15e-3), -0.6, 1e-3);
    EXPECT_NEAR(spacing_change(stretch, 13e-3), -0.3, 0.01);
    EXPECT_NEAR(spacing_change(stretch, 17e-3), -0.3, 0.01);
    EXPECT_NEAR(spacing_change(stretch, 10.6e-3), 0.06, 1e-3);
    EXPECT_NEAR(spacing_change(stretch, 25e-3), 0.0, 1e-6);
}

// Without friction rings come to the force-free spacing sqrt(1 + (1 - (r / R0)^2) / t^2).
TEST(HiddenDevice, SlidesToItsForceFreeSpacing)
{
    const BraidSheet sheet = sheet_of(test::pipeline_4x20());
    constexpr std::size_t rows = 101, columns = 12;
    const std::vector<double> radii(rows * columns, 1.9e-3), force(rows, 1e-3);
    std::vector<double> released;
    for (std::size_t i = 0; i < rows; ++i)
        released.push_back(40e-3 - 0.2e-3 * static_cast<double>(i));
    const std::vector<double> free = slid_rings(sheet, released, radii, force, 1e-7);
    const double spacing = std::sqrt(1.0 + (1.0 - 0.95 * 0.95) / 0.16);
    EXPECT_NEAR(free.front() - free.back(), spacing * 20e-3, 0.01e-3);
}

// The end slides as far as friction takes to bring the wires' axial force F to rest, F / (mu N'),
// with N' the force on the wall for each length; with the force linear in the strain it is moved by
// half of that times the strain at the end. Here F = 0.139 mN at release (by hand, K 0.87 N/m,
// stretch 0.957) and N' = 1 N/m, so friction of 0.05 lets 2.8 mm slide.
TEST(HiddenDevice, SlidesNearItsEndsOnlyAgainstFriction)
{
    const BraidSheet sheet = sheet_of(test::pipeline_4x20());
    constexpr std::size_t rows = 101, columns = 12;
    const std::vector<double> radii(rows * columns, 1.9e-3), force(rows, 0.2e-3);
    std::vector<double> released;
    for (std::size_t i = 0; i < rows; ++i)
        released.push_back(40e-3 - 0.2e-3 * static_cast<double>(i));
    const std::vector<double> slid = slid_rings(sheet, released, radii, force, 0.05);
    EXPECT_GT(slid.front() - released.front(), 0.2e-3);
    EXPECT_LT(slid.front() - released.front(), 0.5e-3);
    EXPECT_NEAR(slid.front() - released.front(), released.back() - slid.back(), 1e-6);
    for (std::size_t i = 20; i <= 80; ++i)
        EXPECT_NEAR(slid[i], released[i], 6e-6) << i;  // the rounding of the friction
}

// k s + k3 s^3 with its energy and slope by central differences.
TEST(HiddenDevice, MeetsWallsThatStiffen)
{
    const WallSprings springs{.stiffness = 3e7, .stiffening = 1e15, .rounding = 2e-6};
    constexpr double depth = 0.1e-3, step = 1e-8;
    const WallEnergy at = wall_energy(springs, depth);
    EXPECT_NEAR(at.pressure, 3e7 * 1e-4 + 1e15 * 1e-12, 0.01 * at.pressure);
    for (const double g : {-5e-6, 0.0, 3e-6, depth}) {
        const WallEnergy here = wall_energy(springs, g), out = wall_energy(springs, g + step),
                         in = wall_energy(springs, g - step);
        EXPECT_NEAR(here.pressure, (out.value - in.value) / (2.0 * step), 1e-3 * at.pressure);
        EXPECT_NEAR(here.slope, (out.pressure - in.pressure) / (2.0 * step), 1e-3 * at.slope);
    }
}

// Two programs for one device: the vessel's mesh has chords of 0.4 mm (10 um), the lattice of 0.5
// mm (16 um), and either bends its wires in its own way.
TEST(HiddenDevice, AgreesWithTheDeploymentWhereNothingIsHidden)
{
    const Difference difference =
        difference_where_nothing_is_hidden(sidewall_belief(BRAIDZONE_SOURCE_DIR));
    ASSERT_GT(difference.num_patches, 250u);
    EXPECT_LT(difference.rms, 15e-6);
    EXPECT_LT(difference.largest, 30e-6);
}

// In front of a neck wider than a narrow vessel the rings have little to hold them.
TEST(HiddenDevice, AgreesInNarrowVesselsWithWideNecks)
{
    Belief belief = sidewall_belief(BRAIDZONE_SOURCE_DIR);
    belief.phantom.sacs.front().neck = 5e-3;
    for (const double radius : {1.85e-3, 1.8e-3, 1.75e-3, 1.7e-3}) {
        belief.phantom.proximal_radius = belief.phantom.distal_radius = radius;
        const Difference difference = difference_where_nothing_is_hidden(belief);
        EXPECT_LT(difference.rms, 8e-6) << radius;
        EXPECT_LT(difference.largest, 40e-6) << radius;
    }
}

}  // namespace braidzone::hidden
