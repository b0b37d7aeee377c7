#include "deploy/opening_braid.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace braidzone {

namespace {

FlowDiverter short_device(double length = 2e-3)
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = length;
    return device;
}

CrimpedBraid crimped_on_axis(double length = 2e-3)
{
    const BraidLattice lattice = make_lattice(short_device(length));
    const Centerline axis = test::tube_centerline(1.85e-3, 6e-3);
    std::vector<CrossSection> rings;
    for (int ring = 0; ring < lattice.num_rings; ++ring)
        rings.push_back(section_at(axis, 4e-3 - ring * lattice.ring_spacing));
    return crimp(lattice, rings, 0.345e-3);
}

/// A channel of 1.8 mm radius that is open to x > 0, where the wall is 2.6 mm away.
WallSupport open_to_one_side(const CrimpedBraid& braid)
{
    WallSupport support;
    for (const Vec3& ray : braid.rays)
        support.stops.push_back(ray.x() > 0.3 ? 2.6e-3 : 1.8e-3);
    return support;
}

OpeningBraid released(const CrimpedBraid& crimped, const WallSupport& support,
                      const DeployOptions& options)
{
    OpeningBraid braid(crimped,
                       spring_coefficients(short_device(), crimped.lattice, options.bending_ratio),
                       support, options);
    while (!braid.all_released())
        braid.release_next_ring();
    return braid;
}

std::vector<DeployOptions> motions()
{
    std::vector<DeployOptions> result(4);
    result[1].motion = Motion::quasi_static;
    result[2].hub_freedom = 1.0;
    result[3].hub_freedom = 1.0;
    result[3].motion = Motion::quasi_static;
    return result;
}

}  // namespace

// Nodes that count as still are left out of the motion, those around them that move wake them: the
// forces that the braid remembers are those of its shape at every stage, and it comes to rest where
// it does if no node ever counts as still.
TEST(OpeningBraid, RestsWhereItDoesIfNoNodeCountsAsStill)
{
    const CrimpedBraid crimped = crimped_on_axis();
    for (DeployOptions options : motions()) {
        const WallSupport support = open_to_one_side(crimped);
        OpeningBraid braid = released(crimped, support, options);
        options.residual_tolerance = 1e-12;
        OpeningBraid restless = released(crimped, support, options);
        for (int i = 0; i < 6000; ++i) {
            braid.step();
            restless.step();
        }
        braid.update_all_forces();
        restless.update_all_forces();
        // 1e-4 c_radial R0, the tolerance, moves a node on its own by 0.2 um.
        const RadialSpring radial =
            spring_coefficients(short_device(), crimped.lattice, options.bending_ratio).radial;
        EXPECT_NEAR(braid.largest_residual(), restless.largest_residual(),
                    1e-4 * radial_stiffness(radial) * 2e-3);
        for (std::size_t node = 0; node < braid.radii().size(); ++node)
            ASSERT_NEAR(braid.radii()[node], restless.radii()[node], 0.2e-6) << node;
    }
}

// The scheme is stable and dissipative: at each step, elastic energy and the kinetic energy of the
// step fall or stay; the two are half a step apart, which lets their sum swing by a part of
// (omega dt)^2 of the kinetic energy. The contact with a rigid wall takes energy away.
TEST(OpeningBraid, LosesEnergyOnItsWayToRest)
{
    const CrimpedBraid crimped = crimped_on_axis();
    for (const DeployOptions& options : motions()) {
        OpeningBraid braid = released(crimped, open_to_one_side(crimped), options);
        const double start = braid.elastic_energy();
        double last = start, last_swing = 0.0;
        for (int i = 0; i < 3000; ++i) {
            braid.step();
            const double energy = braid.elastic_energy() + braid.kinetic_energy();
            const double swing = braid.kinetic_energy();
            EXPECT_LE(energy, last + 2.0 * std::max(swing, last_swing) + 1e-9 * start) << i;
            last = energy;
            last_swing = swing;
        }
        EXPECT_LT(last, 0.05 * start);
        EXPECT_LT(braid.kinetic_energy(), 1e-6 * start);
    }
}

TEST(OpeningBraid, LosesEnergyAtEveryQuasiStaticStep)
{
    const CrimpedBraid crimped = crimped_on_axis();
    DeployOptions options;
    options.motion = Motion::quasi_static;
    OpeningBraid braid = released(crimped, open_to_one_side(crimped), options);
    double last = braid.elastic_energy();
    for (int i = 0; i < 2000; ++i) {
        braid.step();
        const double energy = braid.elastic_energy();
        EXPECT_LE(energy, last * (1.0 + 1e-12)) << i;
        last = energy;
    }
}

TEST(OpeningBraid, NeverPassesARigidWall)
{
    const CrimpedBraid crimped = crimped_on_axis();
    const WallSupport support = open_to_one_side(crimped);
    OpeningBraid braid = released(crimped, support, {});
    for (int i = 0; i < 500; ++i) {
        braid.step();
        for (std::size_t node = 0; node < support.stops.size(); ++node)
            EXPECT_LE(braid.radii()[node], support.stops[node]);
    }
}

// Without wall the force-free lattice is the only rest.
TEST(OpeningBraid, OpensToItsNominalRadiusWhereNothingStopsIt)
{
    const CrimpedBraid crimped = crimped_on_axis();
    for (const DeployOptions& options : motions()) {
        const WallSupport support{std::vector<double>(crimped.rays.size(), 4e-3)};
        OpeningBraid braid = released(crimped, support, options);
        for (int i = 0; i < 6000; ++i)
            braid.step();
        for (double radius : braid.radii())
            EXPECT_NEAR(radius, 2e-3, 1e-7);
    }
}

// The springs of a ring that the wall holds on one side only push its hub away from the wall, and
// the nodes on the open side further out.
TEST(OpeningBraid, ShiftsAFreeHubTowardsTheOpenSide)
{
    const CrimpedBraid crimped = crimped_on_axis();
    const WallSupport support = open_to_one_side(crimped);
    DeployOptions options;
    OpeningBraid fixed = released(crimped, support, options);
    options.hub_freedom = 1.0;
    OpeningBraid free = released(crimped, support, options);
    for (int i = 0; i < 6000; ++i) {
        fixed.step();
        free.step();
    }
    const int ring = crimped.lattice.num_rings / 2;
    const Vec3 shift = free.rings()[static_cast<std::size_t>(ring)].origin -
                       crimped.rings[static_cast<std::size_t>(ring)].origin;
    EXPECT_GT(shift.x(), 20e-6);
    EXPECT_NEAR(shift.z(), 0.0, 1e-12);
    double furthest_fixed = 0.0, furthest_free = 0.0;
    for (std::size_t node = 0; node < crimped.rays.size(); ++node) {
        furthest_fixed = std::max(furthest_fixed, fixed.nodes()[node].x());
        furthest_free = std::max(furthest_free, free.nodes()[node].x());
    }
    EXPECT_GT(furthest_free, furthest_fixed + 10e-6);
    EXPECT_LT(free.largest_residual(), 1e-4 * 0.01885 * 2e-3);
}

// A tied hub rests where its spring bears what the ring's springs press on it with, and moves in
// proportion to its freedom where that is small.
TEST(OpeningBraid, TiesAHubByItsSpring)
{
    const CrimpedBraid crimped = crimped_on_axis();
    const WallSupport support = open_to_one_side(crimped);
    const int ring = crimped.lattice.num_rings / 2;
    const auto index = static_cast<std::size_t>(ring);
    DeployOptions options;
    const SpringCoefficients c =
        spring_coefficients(short_device(), crimped.lattice, options.bending_ratio);
    std::map<double, double> shift;
    for (const double freedom : {0.01, 0.02, 0.5, 0.9, 1.0}) {
        options.hub_freedom = freedom;
        OpeningBraid braid = released(crimped, support, options);
        for (int i = 0; i < 6000; ++i)
            braid.step();
        braid.update_all_forces();
        EXPECT_LT(braid.largest_residual(), 1e-4 * 0.01885 * 2e-3) << freedom;
        shift[freedom] = (braid.rings()[index].origin - crimped.rings[index].origin).x();
        const double press = hub_force(crimped.lattice, c, braid.nodes(), braid.rings(), ring).x();
        const double stiffness = 24 * radial_stiffness(c.radial) * (1.0 - freedom) / freedom;
        EXPECT_NEAR(stiffness * shift[freedom], press, 1e-4 * 0.01885 * 2e-3) << freedom;
    }
    EXPECT_GT(shift[0.01], 0.1e-6);
    EXPECT_NEAR(shift[0.02] / shift[0.01], 2.0, 0.04);
    EXPECT_LT(shift[0.5], shift[0.9]);
    EXPECT_LT(shift[0.9], shift[1.0]);
}

// Braids narrower than nominal fold without bending stiffness, which adds nothing where the radius
// is uniform. A soft wall at 1.8 mm, uniform: K d = f(1.8 mm + d), f the closed form of a node of
// the straight lattice at nominal spacing; by bisection. The ends
// are nineteen rings away; nine rings away they would count 0.3 %.
TEST(OpeningBraid, PushesACompliantWallOutUntilItBalances)
{
    const CrimpedBraid crimped = crimped_on_axis(4e-3);
    const double stop = 1.8e-3, stiffness = 0.2;
    const std::size_t num_nodes = crimped.rays.size();
    const WallSupport support{
        .stops = std::vector<double>(num_nodes, std::numeric_limits<double>::infinity()),
        .stiffness = std::vector<double>(num_nodes, stiffness),
        .wall = std::vector<double>(num_nodes, stop)};
    OpeningBraid braid = released(crimped, support, {});
    for (int i = 0; i < 8000; ++i)
        braid.step();

    const BraidLattice& lattice = crimped.lattice;
    const SpringCoefficients c = spring_coefficients(short_device(), lattice, 0.0);
    const double half_angle = std::numbers::pi / lattice.nodes_per_ring;
    const auto spring_force = [&](double radius) {
        const double arm =
            std::hypot(lattice.ring_spacing, 2.0 * radius * std::sin(0.5 * half_angle));
        return c.radial.bending * (2e-3 - radius) + 4.0 * c.surface * (lattice.arm_length - arm) *
                                                        radius * (1.0 - std::cos(half_angle)) / arm;
    };
    double low = 0.0, high = 0.2e-3;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (stiffness * middle < spring_force(stop + middle) ? low : high) = middle;
    }
    const std::vector<double> displacement = braid.wall_displacements();
    const int node = lattice.node(lattice.num_rings / 2, 5);
    EXPECT_GT(low, 10e-6);
    EXPECT_NEAR(displacement[static_cast<std::size_t>(node)], low, 1e-4 * low);
}

// Jammed wires stop the nodes at 1.8 mm, 0.05 mm beyond a wall too soft to stop them: with
// K = 1e-3 N/m it takes 5e-8 N, a thousandth of the springs' force.
TEST(OpeningBraid, IsStoppedByItsWiresBeyondASoftWall)
{
    const CrimpedBraid crimped = crimped_on_axis(4e-3);
    const std::size_t num_nodes = crimped.rays.size();
    const WallSupport support{.stops = std::vector<double>(num_nodes, 1.8e-3),
                              .stiffness = std::vector<double>(num_nodes, 1e-3),
                              .wall = std::vector<double>(num_nodes, 1.75e-3)};
    OpeningBraid braid = released(crimped, support, {});
    for (int i = 0; i < 8000; ++i)
        braid.step();
    for (const double radius : braid.radii())
        EXPECT_EQ(radius, 1.8e-3);
    for (const double displacement : braid.wall_displacements())
        EXPECT_NEAR(displacement, 0.05e-3, 1e-15);
}

}  // namespace braidzone
