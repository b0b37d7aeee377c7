#pragma once

#include "core/phantom.hpp"
#include "core/vessel.hpp"
#include "deploy/deployment.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/wire_stretch.hpp"
#include "porous/braid_surface.hpp"
#include "porous/range_check.hpp"
#include "support/devices_of_any_size.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <limits>
#include <numbers>
#include <string>

namespace braidzone::test {

/// A tube of one bend between straight ends, and a device across it.
struct Bend {
    double vessel_radius = 1.85e-3;  ///< [m]
    double bend_ratio = 2.0;         ///< radius of the bend over that of the vessel
    double angle = 0.5 * std::numbers::pi;
    double device_ratio = 1.1;  ///< nominal diameter over the vessel's
    int num_wires = 48;
    double straight = 16e-3;  ///< before and behind the bend [m]
    bool force_free = false;
    bool axially_free = false;  ///< the network of wires, else rings locked in their planes
    double friction = infinite_friction;
    double wall_stiffness = std::numeric_limits<double>::infinity();  ///< [Pa/m]
};

/// What became of the device.
struct BendOutcome {
    std::string refused;
    int inverted = 0, outside = 0, jammed = 0;
    double length = 0.0;            ///< along the centerline [m]
    double wire_stretch = 0.0;      ///< [-]
    double coverage = 0.0;          ///< mean [-]
    double inner_coverage = 0.0;    ///< of the bend's middle, 30 degrees to both sides [-]
    double outer_coverage = 0.0;    ///< [-]
    double inner_gap = 0.0;         ///< largest distance from the wall there [m]
    double pressure = 0.0;          ///< mean contact pressure [Pa]
    double force_per_length = 0.0;  ///< [N/m]
    double contact = 0.0;           ///< share of the area
    double cpu_time = 0.0;          ///< [s]
    bool converged = false;
};

/// The device, 14 mm long at rest, with forces from its wires: what both models know.
inline FlowDiverter device_for(const Bend& bend)
{
    FlowDiverter device = pipeline(2.0 * bend.vessel_radius * bend.device_ratio, 14e-3);
    device.num_wires = bend.num_wires;
    device.forces = ForceSource::wire_theory;
    device.youngs_modulus = 200e9;
    return device;
}

inline PhantomVessel vessel_of(const Bend& bend)
{
    // A phantom's bend must be wider than its section.
    const double radius = std::max(bend.bend_ratio, 1.001) * bend.vessel_radius;
    Phantom phantom;
    phantom.segments = {{.length = bend.straight},
                        {.length = radius * bend.angle, .angle = bend.angle},
                        {.length = bend.straight}};
    phantom.proximal_radius = phantom.distal_radius = bend.vessel_radius;
    phantom.edge_length = 0.3e-3;
    return make_phantom(phantom);
}

inline void measure_curves(BendOutcome& outcome, const Bend& bend, const Deployment& deployment,
                           const BraidSurface& surface)
{
    const double bend_length = bend.angle * bend.bend_ratio * bend.vessel_radius;
    const double middle = bend.straight + 0.5 * bend_length;
    double area[2] = {0.0, 0.0}, covered[2] = {0.0, 0.0};
    const int n = deployment.lattice.nodes_per_ring;
    // The axis begins along x and bends towards y.
    const Vec3 inwards(-std::sin(0.5 * bend.angle), std::cos(0.5 * bend.angle), 0.0);
    for (std::size_t i = 0; i < surface.rhombi.size(); ++i) {
        const auto ring = i / static_cast<std::size_t>(n) + 1;
        const CrossSection& plane = deployment.rings[ring];
        if (std::abs(deployment.ring_arc_length[ring] - middle) > 0.3 * bend_length) continue;
        const Vec3 out = (surface.centres[i] - plane.origin).normalized();
        const Vec3 inner = (inwards - inwards.dot(plane.tangent) * plane.tangent).normalized();
        const double cosine = out.dot(inner);
        if (std::abs(cosine) < std::cos(std::numbers::pi / 6.0)) continue;
        const int side = cosine > 0.0 ? 0 : 1;
        area[side] += surface.rhombi[i].area;
        covered[side] += surface.rhombi[i].area * surface.rhombi[i].metal_coverage;
        if (side == 0) outcome.inner_gap = std::max(outcome.inner_gap, surface.wall_distance[i]);
    }
    outcome.inner_coverage = covered[0] / area[0];
    outcome.outer_coverage = covered[1] / area[1];
}

inline BendOutcome outcome_of(const Bend& bend)
{
    BendOutcome outcome;
    const PhantomVessel made = vessel_of(bend);
    const Vessel vessel = make_vessel(made.wall, {"mm", 1e-3});
    const WallTree wall(vessel);
    const Centerline centerline = resample(made.centerline);
    const FlowDiverter device = device_for(bend);
    // The device's middle in that of the bend, as far as its length is known beforehand.
    const double half =
        7e-3 * (bend.force_free || bend.axially_free ? 1.0 + 3.0 * (bend.device_ratio - 1.0) : 1.0);
    const double landing = std::min(0.5 * centerline.length() + half, centerline.length() - 0.5e-3);
    const std::clock_t start = std::clock();
    try {
        DeployOptions options;
        if (bend.axially_free) options.axial = AxialMotion::free;
        options.friction = bend.friction;
        options.wall_stiffness = bend.wall_stiffness;
        ReleaseSchedule schedule;
        schedule.sliding = bend.force_free ? 1.0 : 0.0;
        const Deployment deployment = deploy(device, centerline, wall, landing, schedule, options);
        outcome.cpu_time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        outcome.converged = deployment.converged;
        const DeploymentMeasures measures =
            measure(deployment, device, wall, 3.0 * device.wire_diameter);
        outcome.inverted = measures.inverted_rhombi;
        outcome.outside = measures.nodes_outside_vessel;
        outcome.length = measures.implanted_length;
        outcome.pressure = measures.mean_contact_pressure;
        outcome.force_per_length = measures.radial_force_per_length;
        outcome.contact = measures.contact_area_fraction;
        outcome.wire_stretch = wire_stretch(deployment).total;
        const BraidSurface surface = make_braid_surface(deployment, device);
        outcome.coverage = measure(surface).mean_metal_coverage;
        for (const Rhombus& rhombus : surface.rhombi)
            outcome.jammed += is_jammed(rhombus);
        measure_curves(outcome, bend, deployment, surface);
    } catch (const std::exception& error) {
        outcome.refused = error.what();
    }
    return outcome;
}

}  // namespace braidzone::test
