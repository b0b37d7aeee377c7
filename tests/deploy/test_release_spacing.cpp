#include "deploy/braid_kinematics.hpp"
#include "deploy/release_spacing.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

constexpr int sides = 192;  // a multiple of the 48 directions: rays meet the corners

/// A cone along z, of the given radii at z = 0 and `length`.
struct Cone {
    double proximal_radius, distal_radius, length;

    Vessel vessel() const
    {
        TriangleMesh mesh = test::tube(1.0, length, sides, 1);
        for (Vec3& point : mesh.points) {
            const double radius = std::lerp(proximal_radius, distal_radius, point.z() / length);
            point.x() *= radius;
            point.y() *= radius;
        }
        return make_vessel(std::move(mesh), LengthUnit{"mm", 1e-3});
    }

    Centerline centerline() const
    {
        Polyline line;
        for (int i = 0; i <= 40; ++i) {
            line.points.emplace_back(0, 0, length * i / 40);
            line.inscribed_radii.push_back(0.99 *
                                           std::lerp(proximal_radius, distal_radius, i / 40.0));
        }
        return resample(line, ResampleOptions{.spacing = 0.1e-3, .smoothing = 0.0});
    }
};

}  // namespace

// Half of the directions end at the wall 1.5 mm away, half reach out to R0.
TEST(RestingRadius, CountsTheWallOnlyWithinTheNominalRadius)
{
    const Vessel vessel = test::tube_vessel(1.5e-3, 20e-3, sides, 10);
    const WallTree wall(vessel);
    CrossSection section = section_at(test::tube_centerline(1.5e-3, 20e-3), 10e-3);
    EXPECT_NEAR(resting_radius(section, wall, 2e-3), 1.5e-3, 1e-6);
    EXPECT_NEAR(resting_radius(section, wall, 1.2e-3), 1.2e-3, 1e-15);
}

// At 3.5 in 4 mm: 1.5700 times the nominal length (the paper's Figure 2). The prism of 192 sides
// has radii up to 0.013 % below those of its circle, worth 0.02 % of the length.
TEST(ReleasePositions, AreTheClosedFormInAStraightTube)
{
    FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const Vessel vessel = test::tube_vessel(1.75e-3, 50e-3, sides, 10);
    const WallTree wall(vessel);
    const Centerline centerline = test::tube_centerline(1.75e-3, 50e-3);
    for (const bool centred : {false, true}) {
        const auto positions =
            release_positions(device, lattice, centerline, wall,
                              {.windows = {}, .table = {}, .sliding = 1.0}, 45e-3, centred);
        const double nominal = lattice.ring_spacing * (lattice.num_rings - 1);
        EXPECT_NEAR((positions.front() - positions.back()) / nominal, 1.5700, 4e-4);
        EXPECT_EQ(positions.front(), 45e-3);
        // Uniform to rounding, of the wall's points above all.
        const double first = positions[0] - positions[1];
        for (std::size_t i = 1; i + 1 < positions.size(); ++i)
            EXPECT_NEAR(positions[i] - positions[i + 1], first, 1e-6 * first);
    }
}

// Half-way between nominal and force-free: 1 + 0.57 / 2.
TEST(ReleasePositions, LieBetweenNominalAndForceFreeWhereRingsSlideInPart)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const WallTree wall(test::tube_vessel(1.75e-3, 50e-3, sides, 10));
    const Centerline centerline = test::tube_centerline(1.75e-3, 50e-3);
    const auto length_over_nominal = [&](double sliding) {
        const auto positions = release_positions(device, lattice, centerline, wall,
                                                 {.sliding = sliding}, 45e-3, false);
        return (positions.front() - positions.back()) /
               (lattice.ring_spacing * (lattice.num_rings - 1));
    };
    EXPECT_NEAR(length_over_nominal(0.0), 1.0, 1e-12);
    EXPECT_NEAR(length_over_nominal(0.5), 1.2850, 2e-4);
    EXPECT_NEAR(length_over_nominal(1e-3), 1.00057, 1e-6);
}

// The rings of a flare are at rest until they slide, and force-free in the end.
TEST(ReleasePositions, SlideFromTheRestingSpacingOfAFlare)
{
    FlowDiverter device = test::pipeline_4x20();
    device.proximal_flare = 0.1e-3;
    device.flare_length = 4e-3;
    const BraidLattice lattice = make_lattice(device);
    const WallTree wall(test::tube_vessel(1.75e-3, 50e-3, sides, 10));
    const Centerline centerline = test::tube_centerline(1.75e-3, 50e-3);
    const auto end = [&](double sliding) {
        return release_positions(device, lattice, centerline, wall, {.sliding = sliding}, 45e-3,
                                 false)
            .back();
    };
    EXPECT_NEAR(end(1e-6), end(0.0), 20e-3 * 1e-6);
    EXPECT_NEAR(end(0.5), 0.5 * (end(0.0) + end(1.0)), 1e-9);
}

TEST(ReleasePositions, MultiplyTheForceFreeSpacingByTheWindows)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const Vessel vessel = test::tube_vessel(1.75e-3, 50e-3, sides, 10);
    const WallTree wall(vessel);
    const ReleaseSchedule push{
        .windows = {{.from = 10e-3, .to = 40e-3, .spacing = 0.5}}, .table = {}, .sliding = 1.0};
    const auto positions = release_positions(device, lattice, test::tube_centerline(1.75e-3, 50e-3),
                                             wall, push, 45e-3, false);
    const double nominal = lattice.ring_spacing * (lattice.num_rings - 1);
    // 5 mm at 1.57, the rest at 0.785.
    EXPECT_NEAR(positions.back(), 40e-3 - 0.5 * 1.57 * (nominal - 5e-3 / 1.57), 0.01e-3);
}

// In a cone x = R / R0 = x0 + k s, and the braid below a place is
//     integral ds / lambda = (t / k) (asin(x / w) - asin(x_end / w)),   w = sqrt(1 + t^2).
// With twice as many wires the ring spacing is halved, and the error falls by four.
TEST(ReleasePositions, ConvergeAtSecondOrderInACone)
{
    const Cone cone{1.9e-3, 1.1e-3, 40e-3};
    const Vessel vessel = cone.vessel();
    const WallTree wall(vessel);
    const Centerline centerline = cone.centerline();
    const auto error = [&](int num_wires) {
        FlowDiverter device = test::pipeline_4x20();
        device.num_wires = num_wires;
        const BraidLattice lattice = make_lattice(device);
        const double landing = 36e-3;
        const auto positions =
            release_positions(device, lattice, centerline, wall,
                              {.windows = {}, .table = {}, .sliding = 1.0}, landing, false);
        const double braid = lattice.ring_spacing * (lattice.num_rings - 1);
        const double t = device.braid_ratio, w = std::sqrt(1.0 + t * t);
        // Of the prism that stands for the cone: the rays meet it between its corners.
        const auto ratio = [&](double s) {
            return resting_radius(section_at(centerline, s), wall, 2e-3) / 2e-3;
        };
        const double start = ratio(landing), slope = (start - ratio(2e-3)) / (landing - 2e-3);
        const double end = w * std::sin(std::asin(start / w) - slope * braid / t);
        return std::abs(positions.back() - (landing + (end - start) / slope));
    };
    const double coarse = error(24), fine = error(48);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.3);
    EXPECT_LT(fine, 0.1e-6);
}

// A device whose end would lie below the centerline is laid down on as if the vessel went on; that
// it does not fit is for `deploy` to say.
TEST(ReleasePositions, GoOnBeyondTheCenterline)
{
    const FlowDiverter device = test::pipeline_4x20();
    const BraidLattice lattice = make_lattice(device);
    const Vessel vessel = test::tube_vessel(1.75e-3, 20e-3, sides, 10);
    const WallTree wall(vessel);
    const auto positions =
        release_positions(device, lattice, test::tube_centerline(1.75e-3, 20e-3), wall,
                          {.windows = {}, .table = {}, .sliding = 1.0}, 15e-3, false);
    EXPECT_LT(positions.back(), -10e-3);
}

}  // namespace braidzone
