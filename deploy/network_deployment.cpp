#include "deploy/network_deployment.hpp"

#include "core/error.hpp"
#include "deploy/axial_release.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/landing_zone.hpp"
#include "deploy/plane_release.hpp"
#include "deploy/release_spacing.hpp"
#include "deploy/ring_centring.hpp"
#include "deploy/ring_planes.hpp"
#include "deploy/spring_forces.hpp"
#include "deploy/wire_jam.hpp"
#include "deploy/wire_theory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace braidzone {

namespace {

/// Distance from the wall at which contact begins, over the nominal radius, as in `deploy`.
constexpr double contact_offset_ratio = 5e-4;

/// Of an arm, in place of the wire's own 5e5 N/m: iterations to rest grow with it.
constexpr double largest_axial_stiffness = 2e4;

/// Stiffness of a node's contact with the wall over that of its radial spring. A node of a Pipeline
/// bears up to 10 mN where a bend meets the distal end, which then sinks in by a tenth of a
/// micrometre.
constexpr double contact_ratio = 8e4;

/// Iterations converge or do not; they cost a thousand times as much as the steps of a braid whose
/// nodes stay on their rays, so that many more would only delay the message.
constexpr int most_settling_iterations = 1000;

/// Rings that are not laid out yet are shown where the last one is.
std::vector<Vec3> nodes_to_show(const BraidLattice& lattice, const NetworkShape& shape)
{
    std::vector<Vec3> nodes = shape.nodes;
    const auto n = static_cast<std::size_t>(lattice.nodes_per_ring);
    for (std::size_t i = n * static_cast<std::size_t>(shape.num_rings); i < nodes.size(); ++i)
        nodes[i] = nodes[i - n];
    return nodes;
}

bool is_axially_free(const DeployOptions& options)
{
    return options.axial == AxialMotion::free;
}

void require_consistent(const ReleaseSchedule& schedule, const DeployOptions& options)
{
    if (options.lattice != LatticeKind::crossings) {
        throw ConfigError(
            "deployment.lattice = \"paper-2020\" goes with rings that are locked in their planes "
            "and nodes on rays only; allowed with axial = \"free\" or hoop_migration = true is "
            "\"crossings\"");
    }
    if (std::isfinite(options.wall_stiffness)) {
        throw ConfigError(
            "deployment.wall_stiffness does not go together with axial = \"free\" or "
            "hoop_migration = true; leave it out for a rigid wall");
    }
    if (!schedule.twists.empty() || !schedule.incomplete_openings.empty()) {
        throw ConfigError(fmt::format(
            "deployment.{} goes with nodes that stay on their rays only; it cannot stand beside "
            "axial = \"free\" or hoop_migration = true",
            schedule.twists.empty() ? "incomplete_opening" : "twist"));
    }
    if (options.hub_shift > 0.0) {
        throw ConfigError(fmt::format(
            "deployment.hub_shift = {:.6g} mm does not go together with axial = \"free\" or "
            "hoop_migration = true, where rings find their own place; leave it out",
            1e3 * options.hub_shift));
    }
    if (options.hub_freedom > 0.0 && options.hub_freedom < 1.0) {
        throw ConfigError(fmt::format(
            "deployment.hub_freedom = {:.6g}: with axial = \"free\" or hoop_migration = true the "
            "hub of a ring is the mean of its nodes; leave it out",
            options.hub_freedom));
    }
    if (!is_axially_free(options)) return;
    if (schedule.sliding > 0.0) {
        throw ConfigError(
            "deployment.sliding (1 with release = \"force_free\") prescribes the ring spacing, "
            "which is free with axial = \"free\"; leave it out there");
    }
    if (options.release_order == ReleaseOrder::at_once) {
        throw ConfigError(
            "deployment.release_order = \"at_once\" does not go together with axial = \"free\", "
            "where the catheter retreats with the device; allowed is \"ring_by_ring\"");
    }
    if (!schedule.windows.empty() || !schedule.table.empty()) {
        throw ConfigError(
            "deployment.push_pull and spacing_table prescribe the ring spacing, which is free with "
            "axial = \"free\"; allowed are both with axial = \"locked\"");
    }
}

/// Where the proximal end will lie is not known before the release.
void require_landing_on_centerline(double landing_distal, const Centerline& centerline)
{
    if (landing_distal >= 0.0 && landing_distal <= centerline.length()) return;
    throw GeometryError(
        fmt::format("deployment.landing_distal = {:.6g} mm is not on the centerline, which runs "
                    "from 0 to {:.6g} mm",
                    1e3 * landing_distal, 1e3 * centerline.length()));
}

ReleasedNetwork release(const WireNetwork& network, const FlowDiverter& device,
                        const Centerline& centerline, const WallTree& wall, double landing_distal,
                        const ReleaseSchedule& schedule, const DeployOptions& options,
                        const NetworkRelease& common)
{
    const double catheter_radius = 0.5 * device.catheter_diameter;
    if (is_axially_free(options)) {
        require_landing_on_centerline(landing_distal, centerline);
        return release_along_axis(network, centerline, wall, {landing_distal, catheter_radius},
                                  common);
    }
    const std::vector<double> positions = release_positions(
        device, network.lattice, centerline, wall, schedule, landing_distal, options.centre_rings);
    require_device_on_centerline(centerline, positions);
    std::vector<CrossSection> rings;
    if (options.centre_rings) {
        rings = centred_rings(centerline, wall, positions, network.lattice.nominal_radius);
    } else {
        for (double position : positions)
            rings.push_back(section_at(centerline, position));
    }
    rings = uncrossed_rings(
        std::move(rings), wall, network.lattice.nominal_radius,
        std::vector<double>(positions.size() - 1, least_plane_gap(device, network.lattice)));
    const CrimpedBraid crimped = crimp(network.lattice, rings, catheter_radius);
    require_room_for_catheter(crimped, positions, wall);
    return release_in_planes(network, crimped, positions, options.release_order, wall, common);
}

}  // namespace

bool needs_wire_network(const DeployOptions& options)
{
    return is_axially_free(options) || options.hoop_migration;
}

WireNetwork wire_network(const FlowDiverter& device, const DeployOptions& options)
{
    WireNetwork network;
    network.lattice = make_lattice(device);
    const SpringCoefficients springs =
        spring_coefficients(device, network.lattice, options.bending_ratio);
    const bool modulus_is_known = device.youngs_modulus > 0.0;
    if (is_axially_free(options) && !modulus_is_known) {
        throw ConfigError(
            "deployment.axial = \"free\" needs the stiffness of the wires; give "
            "device.youngs_modulus");
    }
    network.axial_stiffness = is_axially_free(options)
                                  ? std::min(wire_axial_stiffness(device), largest_axial_stiffness)
                                  : springs.force_scale * springs.surface;
    network.bending_stiffness = modulus_is_known ? crossing_bending_stiffness(device)
                                                 : springs.force_scale * springs.bending;
    network.radial = scaled(springs.radial, springs.force_scale);
    return network;
}

Deployment deploy_wire_network(const FlowDiverter& device, const Centerline& centerline,
                               const WallTree& wall, double landing_distal,
                               const ReleaseSchedule& schedule, const DeployOptions& options)
{
    require_consistent(schedule, options);
    const WireNetwork network = wire_network(device, options);

    Deployment result;
    MotionRecord<std::vector<Vec3>> record(options.num_frames);
    NetworkRelease common{
        .friction = options.friction,
        .contact_offset = contact_offset_ratio * network.lattice.nominal_radius,
        .contact_stiffness = contact_ratio * radial_stiffness(network.radial),
        .force_tolerance = options.residual_tolerance * radial_stiffness(network.radial) *
                           network.lattice.nominal_radius,
        .most_iterations = std::min(options.max_settling_steps, most_settling_iterations),
        .report = {}};
    common.report = [&](int iterations, int num_released, const NetworkShape& shape,
                        double residual) {
        if (options.num_frames > 0)
            record.add(iterations, num_released, nodes_to_show(network.lattice, shape));
        result.residual_history.push_back({iterations, residual});
    };
    const ReleasedNetwork released =
        release(network, device, centerline, wall, landing_distal, schedule, options, common);
    require_fitting_diameter(device, released.rings);

    result.lattice = network.lattice;
    result.nodes = released.nodes;
    result.rings = released.rings;
    result.ring_arc_length = released.ring_arc_length;
    result.contact_force = released.contact_force;
    result.wall_displacement.assign(released.nodes.size(), 0.0);
    const std::vector<double> areas = node_areas(result.lattice, result.nodes);
    for (std::size_t i = 0; i < result.nodes.size(); ++i) {
        result.wall_distance.push_back(wall.nearest(result.nodes[i]).distance);
        result.in_contact.push_back(result.wall_distance[i] <= 0.5 * device.wire_diameter ? 1 : 0);
        result.contact_pressure.push_back(result.contact_force[i] / areas[i]);
    }
    result.max_force_residual = released.residual;
    result.force_tolerance = common.force_tolerance;
    result.converged = released.residual <= common.force_tolerance;
    result.steps = released.iterations;
    for (auto& entry : record.finish(released.iterations, network.lattice.num_rings, result.nodes))
        result.frames.push_back({entry.step, entry.num_released, std::move(entry.shape)});
    return result;
}

}  // namespace braidzone
