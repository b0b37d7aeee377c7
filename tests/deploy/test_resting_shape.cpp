#include "deploy/deployment.hpp"
#include "deploy/resting_shape.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace braidzone {
namespace {

constexpr double length = 12e-3;

FlowDiverter short_device()
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 6e-3;
    return device;
}

/// A straight braid at its force-free spacing, and its springs.
struct StraightBraid {
    CrimpedBraid crimped;
    SpringCoefficients coefficients;

    StraightBraid()
    {
        const FlowDiverter device = short_device();
        const BraidLattice lattice = make_lattice(device);
        std::vector<CrossSection> rings;
        for (int ring = 0; ring < lattice.num_rings; ++ring) {
            rings.push_back({.origin = Vec3(0.0, 0.0, 9e-3 - ring * lattice.ring_spacing),
                             .tangent = Vec3::UnitZ(),
                             .normal = Vec3::UnitX(),
                             .binormal = Vec3::UnitY()});
        }
        crimped = crimp(lattice, rings, 0.3e-3);
        coefficients = spring_coefficients(device, lattice, 0.25);
    }

    WallSupport stops_at(double radius) const
    {
        return {std::vector<double>(crimped.rays.size(), radius), {}};
    }
};

/// A tube of 1.7 mm that is drawn out to one side in its middle, as a sac without a sharp neck.
Vessel bulging_vessel()
{
    TriangleMesh mesh = test::tube(1.7e-3, length, 96, 96);
    for (Vec3& point : mesh.points) {
        const double along = std::exp(-std::pow((point.z() - 0.5 * length) / 1.2e-3, 2));
        const double around =
            std::pow(std::max(0.0, std::cos(std::atan2(point.y(), point.x()))), 2);
        point.head<2>() *= 1.0 + 0.5 * along * around;
    }
    return make_vessel(mesh, LengthUnit{});
}

/// Largest distance between the nodes that a motion ends in and those that are solved for.
double largest_difference(const DeployOptions& options, const ReleaseSchedule& schedule = {})
{
    const Vessel vessel = bulging_vessel();
    const auto deployed = [&](Motion motion) {
        DeployOptions with = options;
        with.motion = motion;
        with.residual_tolerance = 1e-6;
        const Deployment result = deploy(short_device(), test::tube_centerline(1.7e-3, length),
                                         WallTree(vessel), 9e-3, schedule, with);
        EXPECT_TRUE(result.converged);
        return result;
    };
    const Deployment moved = deployed(Motion::inertial), solved = deployed(Motion::none);
    EXPECT_EQ(moved.in_contact, solved.in_contact);
    EXPECT_LT(solved.steps, 12);  // quadratic convergence: a wrong Hessian takes more
    double largest = 0.0;
    for (std::size_t i = 0; i < moved.nodes.size(); ++i)
        largest = std::max(largest, (moved.nodes[i] - solved.nodes[i]).norm());
    return largest;
}

}  // namespace

// With room all around the braid takes its nominal radius, at which no spring is stretched.
TEST(RestingShape, IsForceFreeWhereNothingHoldsTheBraid)
{
    const StraightBraid braid;
    const RestingShape rest =
        find_resting_shape(braid.crimped, braid.coefficients, braid.stops_at(4e-3), 1e-12);
    EXPECT_TRUE(rest.is_at_rest);
    for (const double radius : rest.radii)
        EXPECT_NEAR(radius, 2e-3, 1e-9);
}

// Held at 1.7 mm all around: no node leaves its stop, and each bears q c (R0 - r) of its radial
// spring besides what the arms add.
TEST(RestingShape, StaysOnItsStops)
{
    StraightBraid braid;
    braid.coefficients.surface = 0.0;
    const RestingShape rest =
        find_resting_shape(braid.crimped, braid.coefficients, braid.stops_at(1.7e-3), 1e-12);
    EXPECT_TRUE(rest.is_at_rest);
    EXPECT_EQ(rest.residual, 0.0);
    const BraidLattice& lattice = braid.crimped.lattice;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const auto node = static_cast<std::size_t>(lattice.node(ring, 0));
        EXPECT_EQ(rest.radii[node], 1.7e-3);
        EXPECT_NEAR(rest.spring_forces[node],
                    lattice.area_share(ring) * braid.coefficients.radial.bending * 0.3e-3, 1e-12);
    }
}

// A wall of springs K per node alone against radial springs c: r = stop + c (R0 - stop) / (K + c)
// where all nodes are alike.
TEST(RestingShape, BalancesACompliantWall)
{
    StraightBraid braid;
    braid.coefficients.surface = 0.0;
    WallSupport support = braid.stops_at(std::numeric_limits<double>::infinity());
    support.wall.assign(support.stops.size(), 1.7e-3);
    const double c = braid.coefficients.radial.bending;
    for (int ring = 0; ring < braid.crimped.lattice.num_rings; ++ring) {
        for (int column = 0; column < braid.crimped.lattice.nodes_per_ring; ++column)
            support.stiffness.push_back(2.0 * c * braid.crimped.lattice.area_share(ring));
    }
    const RestingShape rest = find_resting_shape(braid.crimped, braid.coefficients, support, 1e-13);
    EXPECT_TRUE(rest.is_at_rest);
    for (const double radius : rest.radii)
        EXPECT_NEAR(radius, 1.8e-3, 1e-9);

    // Jammed wires stop it before the wall does.
    support.stops.assign(support.stops.size(), 1.75e-3);
    const RestingShape jammed =
        find_resting_shape(braid.crimped, braid.coefficients, support, 1e-13);
    EXPECT_TRUE(jammed.is_at_rest);
    for (const double radius : jammed.radii)
        EXPECT_EQ(radius, 1.75e-3);
}

// The motion of the paper ends in the same shape.
TEST(RestingShape, IsWhereTheMotionEnds)
{
    EXPECT_LT(largest_difference({}), 0.02e-6);
}

TEST(RestingShape, IsWhereTheMotionEndsWithAPush)
{
    EXPECT_LT(largest_difference({}, {.windows = {{4.5e-3, 7.5e-3, 0.5}}}), 0.02e-6);
}

// The arms of a twisted braid have rest lengths of their own, which the Hessian must have too.
TEST(RestingShape, IsWhereTheMotionEndsWithATwist)
{
    EXPECT_LT(
        largest_difference({}, {.twists = {{.angle = 1.5, .centre = 6e-3, .half_width = 1.5e-3}}}),
        0.02e-6);
}

TEST(RestingShape, IsWhereTheMotionEndsOnACompliantWall)
{
    EXPECT_LT(largest_difference({.wall_stiffness = 5e7}), 0.02e-6);
}

}  // namespace braidzone
