#include "deploy/deployment.hpp"

#include "core/error.hpp"
#include "deploy/crimped_braid.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/hub_shift.hpp"
#include "deploy/landing_zone.hpp"
#include "deploy/lattice_mapping.hpp"
#include "deploy/network_deployment.hpp"
#include "deploy/opening_braid.hpp"
#include "deploy/release_spacing.hpp"
#include "deploy/resting_shape.hpp"
#include "deploy/ring_centring.hpp"
#include "deploy/ring_planes.hpp"
#include "deploy/spring_forces.hpp"
#include "deploy/wall_contact.hpp"
#include "deploy/wire_jam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace braidzone {

namespace {

/// Distance from the wall at which nodes are held, over the nominal radius: 1 um for a 4 mm device,
/// far below a wire's radius and far above the rounding of single-precision surfaces.
constexpr double contact_offset_ratio = 5e-4;

/// How far the wall is looked for along a ray, over the nominal radius. No braid opens beyond
/// R0 sqrt(1 + t^2), 1.14 R0 for the steepest of the library; the rest is room for the swing.
constexpr double reach_ratio = 2.0;

/// Width over which the wall's stop of a node passes into that of its jammed wires, over the
/// nominal radius: where both are at the same place the node stops 10 um before them for a 4 mm
/// device, less than a wire's radius.
constexpr double jam_rounding_ratio = 0.02;

/// Steps between two samples of `Deployment::residual_history`.
constexpr int residual_interval = 25;

std::vector<CrossSection> sections_at(const Centerline& centerline,
                                      const std::vector<double>& arc_lengths)
{
    std::vector<CrossSection> sections;
    for (double arc_length : arc_lengths)
        sections.push_back(section_at(centerline, arc_length));
    return sections;
}

/// The braid in its catheter, its rings where they are released.
CrimpedBraid lay_out_rings(const FlowDiverter& device, const BraidLattice& lattice,
                           const std::vector<double>& positions,
                           const std::vector<AxialTwist>& twists, const Centerline& centerline,
                           const WallTree& wall, const DeployOptions& options)
{
    std::vector<CrossSection> rings =
        options.centre_rings ? centred_rings(centerline, wall, positions, lattice.nominal_radius)
                             : sections_at(centerline, positions);
    if (options.hub_shift > 0.0)
        shift_hubs(rings, positions, wall, lattice.nominal_radius, options.hub_shift);
    rings = uncrossed_rings(
        std::move(rings), wall, lattice.nominal_radius,
        std::vector<double>(positions.size() - 1, least_plane_gap(device, lattice)));
    const std::vector<double> turns = ring_turns(twists, lattice, positions);
    return crimp(twisted(lattice, turns), rings, 0.5 * device.catheter_diameter, turns);
}

std::vector<double> stops_in_vessel(const CrimpedBraid& braid, const WallTree& wall)
{
    const double nominal_radius = braid.lattice.nominal_radius;
    return wall_stops(braid, wall, reach_ratio * nominal_radius,
                      contact_offset_ratio * nominal_radius);
}

/// Where nodes stop: at the wall, or before it where their wires jam.
/// @param wall_stops  infinite where only jammed wires stop the nodes [m]
std::vector<double> stops_of(const std::vector<double>& wall_stops, const CrimpedBraid& braid,
                             const FlowDiverter& device)
{
    const std::vector<double> jam = jam_stops(braid, least_ring_spacing(device, braid.lattice));
    std::vector<double> stops;
    for (std::size_t i = 0; i < jam.size(); ++i) {
        stops.push_back(std::max(
            braid.radius,
            nearer_stop(wall_stops[i], jam[i], jam_rounding_ratio * braid.lattice.nominal_radius)));
    }
    return stops;
}

/// @param stiffness  of the wall, see `wall_stiffnesses`; empty for a rigid one
WallSupport support_of(const std::vector<double>& wall_stops, std::vector<double> stiffness,
                       const CrimpedBraid& braid, const FlowDiverter& device)
{
    if (stiffness.empty()) return {.stops = stops_of(wall_stops, braid, device)};
    const std::vector<double> no_wall(wall_stops.size(), std::numeric_limits<double>::infinity());
    return {.stops = stops_of(no_wall, braid, device),
            .stiffness = std::move(stiffness),
            .wall = wall_stops};
}

/// A braid at rest, forces in newtons.
struct RestingBraid {
    std::vector<double> radii;              ///< |N| distance to the hub along the ray [m]
    std::vector<double> spring_forces;      ///< |N| radial, outwards [N]
    std::vector<double> wall_displacement;  ///< |N| [m]
    std::vector<MotionRecord<std::vector<double>>::Entry> record;  ///< of the radii
    std::vector<ResidualSample> residual_history;
    double residual = 0.0;   ///< [N]
    double tolerance = 0.0;  ///< [N]
    int steps = 0;
};

/// Force that counts as none on a braid at rest, in the units of the coefficients [N].
double rest_tolerance(const CrimpedBraid& crimped, const SpringCoefficients& coefficients,
                      const DeployOptions& options)
{
    return options.residual_tolerance * radial_stiffness(coefficients.radial) *
           crimped.lattice.nominal_radius;
}

/// Solved to this much less than the tolerance, at the cost of one more iteration: derivatives of
/// the shape by the case's parameters are then smooth.
constexpr double direct_tolerance_ratio = 0.01;

/// The braid at rest without a motion that leads there.
RestingBraid solve_for_rest(const CrimpedBraid& crimped, const SpringCoefficients& coefficients,
                            const WallSupport& support, const DeployOptions& options)
{
    const double tolerance = rest_tolerance(crimped, coefficients, options);
    const RestingShape shape =
        find_resting_shape(crimped, coefficients, support, direct_tolerance_ratio * tolerance);
    RestingBraid rest;
    const double scale = coefficients.force_scale;
    rest.radii = shape.radii;
    rest.spring_forces = shape.spring_forces;
    for (double& force : rest.spring_forces)
        force *= scale;
    for (std::size_t i = 0; i < rest.radii.size(); ++i)
        rest.wall_displacement.push_back(support.wall_displacement(i, rest.radii[i]));
    rest.residual = scale * shape.residual;
    rest.tolerance = scale * tolerance;
    rest.steps = shape.iterations;
    rest.residual_history.push_back({rest.steps, rest.residual});
    return rest;
}

/// Opens the braid until no free node bears a force above the tolerance.
RestingBraid open(const CrimpedBraid& crimped, const SpringCoefficients& coefficients,
                  const WallSupport& support, const DeployOptions& options)
{
    OpeningBraid braid(crimped, coefficients, support, options);
    RestingBraid rest;
    MotionRecord<std::vector<double>> record(options.num_frames);
    const double scale = coefficients.force_scale;
    const auto step = [&] {
        if (record.wants(rest.steps)) record.add(rest.steps, braid.num_released(), braid.radii());
        braid.step();
        ++rest.steps;
        if (rest.steps % residual_interval == 0)
            rest.residual_history.push_back({rest.steps, scale * braid.largest_residual()});
    };

    while (!braid.all_released()) {
        braid.release_next_ring();
        if (options.release_order == ReleaseOrder::at_once) continue;
        for (int i = 0; i < options.release_interval; ++i)
            step();
    }
    if (rest.steps == 0) step();  // the forces of a braid that never moved are not known
    rest.tolerance = scale * rest_tolerance(crimped, coefficients, options);
    const int last_step = rest.steps + options.max_settling_steps;
    const auto is_at_rest = [&] { return scale * braid.largest_residual() <= rest.tolerance; };
    while (rest.steps < last_step) {
        if (is_at_rest()) {
            braid.update_all_forces();  // those of the nodes that the last step moved
            if (is_at_rest()) break;
        }
        step();
    }
    braid.update_all_forces();

    rest.radii = braid.radii();
    rest.spring_forces = braid.spring_forces();
    for (double& force : rest.spring_forces)
        force *= scale;
    rest.wall_displacement = braid.wall_displacements();
    rest.residual = scale * braid.largest_residual();
    if (rest.residual_history.empty() || rest.residual_history.back().step != rest.steps)
        rest.residual_history.push_back({rest.steps, rest.residual});
    rest.record = record.finish(rest.steps, braid.num_released(), rest.radii);
    return rest;
}

/// Refuses a braid whose nodes have passed the hubs of their rings: it has buckled, and what comes
/// out on the other side meets no wall.
void require_unbuckled(const RestingBraid& rest, const BraidLattice& lattice,
                       const std::vector<double>& positions)
{
    const auto passed = [](double radius) { return !(radius > 0.0); };
    const auto num_passed = std::count_if(rest.radii.begin(), rest.radii.end(), passed);
    if (num_passed == 0) return;
    const auto first = std::find_if(rest.radii.begin(), rest.radii.end(), passed);
    const auto ring = (first - rest.radii.begin()) / lattice.nodes_per_ring;
    throw GeometryError(fmt::format(
        "the braid buckles: {} of {} nodes pass the middle of their ring, the first at {:.6g} mm "
        "along the centerline; rings that are held so near to each other leave its wires too long "
        "for the vessel there; take a smaller device.diameter, or deployment.release = "
        "\"force_free\"",
        num_passed, rest.radii.size(), 1e3 * positions[static_cast<std::size_t>(ring)]));
}

/// How far nodes lie beyond the wall as it was, along their rays [m].
std::vector<double> beyond(const std::vector<double>& stops, const std::vector<double>& radii)
{
    std::vector<double> distances;
    for (std::size_t i = 0; i < radii.size(); ++i)
        distances.push_back(std::max(0.0, radii[i] - stops[i]));
    return distances;
}

std::vector<Vec3> nodes_at(const CrimpedBraid& braid, const std::vector<double>& radii)
{
    std::vector<Vec3> nodes;
    nodes.reserve(radii.size());
    for (int node = 0; node < braid.lattice.num_nodes(); ++node)
        nodes.push_back(on_ray(braid, node, radii[static_cast<std::size_t>(node)]));
    return nodes;
}

/// Places of the nodes, their distance from the wall, and which of them touch it.
void set_shape(Deployment& deployment, const CrimpedBraid& braid, const std::vector<double>& radii,
               const std::vector<double>& wall_displacement, const WallTree& wall,
               double wire_diameter)
{
    deployment.lattice = braid.lattice;
    deployment.rings = braid.rings;
    deployment.nodes = nodes_at(braid, radii);
    deployment.wall_displacement = wall_displacement;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const bool displaced = wall_displacement[i] > 0.0;
        const double distance = displaced ? 0.0 : wall.nearest(deployment.nodes[i]).distance;
        deployment.wall_distance.push_back(distance);
        deployment.in_contact.push_back(distance <= 0.5 * wire_diameter ? 1 : 0);
    }
}

/// What the nodes in contact bear out of the radial forces of all nodes' springs.
std::vector<double> contact_forces(const std::vector<double>& spring_forces,
                                   const std::vector<char>& in_contact)
{
    std::vector<double> forces;
    forces.reserve(spring_forces.size());
    for (std::size_t i = 0; i < spring_forces.size(); ++i)
        forces.push_back(in_contact[i] ? std::max(0.0, spring_forces[i]) : 0.0);
    return forces;
}

void set_contact_force(Deployment& deployment, const std::vector<double>& forces)
{
    deployment.contact_force = forces;
    const std::vector<double> areas = node_areas(deployment.lattice, deployment.nodes);
    for (std::size_t i = 0; i < forces.size(); ++i)
        deployment.contact_pressure.push_back(forces[i] / areas[i]);
}

/// The shape of a braid on its own lattice.
Deployment as_it_is(const CrimpedBraid& braid, const RestingBraid& rest, const WallTree& wall,
                    double wire_diameter)
{
    Deployment result;
    set_shape(result, braid, rest.radii, rest.wall_displacement, wall, wire_diameter);
    set_contact_force(result, contact_forces(rest.spring_forces, result.in_contact));
    for (const auto& entry : rest.record)
        result.frames.push_back({entry.step, entry.num_released, nodes_at(braid, entry.shape)});
    return result;
}

/// The crossings of the wires, laid onto a coarse lattice at rest. A crossing that would lie beyond
/// the wall between coarse nodes is set on the wall, along its ray.
Deployment laid_onto(const Deployment& coarse, const RestingBraid& rest,
                     const LatticeMapping& mapping, const CrimpedBraid& crossings,
                     const WallTree& wall, const FlowDiverter& device)
{
    const std::vector<double> wall_stops = stops_in_vessel(crossings, wall);
    std::vector<double> displaced_wall = carried_over(mapping, rest.wall_displacement);
    for (std::size_t i = 0; i < displaced_wall.size(); ++i)
        displaced_wall[i] = wall_stops[i] + std::max(0.0, displaced_wall[i]);
    const std::vector<double> stops = stops_of(displaced_wall, crossings, device);
    const auto radii_of = [&](const std::vector<double>& coarse_radii) {
        std::vector<double> radii = carried_over(mapping, coarse_radii);
        for (std::size_t i = 0; i < radii.size(); ++i)
            radii[i] = std::min(radii[i], stops[i]);
        return radii;
    };
    const std::vector<double> radii = radii_of(rest.radii);
    Deployment result;
    set_shape(result, crossings, radii, beyond(wall_stops, radii), wall, device.wire_diameter);
    set_contact_force(
        result,
        carried_over_forces(mapping, coarse.contact_force, node_areas(coarse.lattice, coarse.nodes),
                            node_areas(result.lattice, result.nodes), result.in_contact));
    for (const auto& entry : rest.record) {
        result.frames.push_back(
            {entry.step, entry.num_released, nodes_at(crossings, radii_of(entry.shape))});
    }
    return result;
}

}  // namespace

Deployment deploy(const FlowDiverter& device, const Centerline& centerline, const WallTree& wall,
                  double landing_distal, const ReleaseSchedule& schedule,
                  const DeployOptions& options)
{
    validate(schedule);
    if (needs_wire_network(options)) {
        return deploy_wire_network(device, centerline, wall, landing_distal, schedule, options);
    }
    const BraidLattice lattice = make_lattice(device, options.lattice);
    std::vector<double> positions = release_positions(device, lattice, centerline, wall, schedule,
                                                      landing_distal, options.centre_rings);
    require_device_on_centerline(centerline, positions);
    const CrimpedBraid crimped =
        lay_out_rings(device, lattice, positions, schedule.twists, centerline, wall, options);
    require_room_for_catheter(crimped, positions, wall);
    require_fitting_diameter(device, crimped.rings);

    const SpringCoefficients coefficients =
        spring_coefficients(device, lattice, options.bending_ratio);
    const std::vector<double> wall_stops = stops_in_vessel(crimped, wall);
    const bool is_compliant = std::isfinite(options.wall_stiffness);
    std::vector<double> stiffness;
    if (is_compliant) {
        stiffness = wall_stiffnesses(crimped, wall_stops,
                                     options.wall_stiffness / coefficients.force_scale);
    }
    const WallSupport support =
        support_of(narrowed_stops(schedule.incomplete_openings, wall_stops, lattice, positions,
                                  device.braid_ratio, crimped.radius),
                   std::move(stiffness), crimped, device);
    RestingBraid rest = options.motion == Motion::none
                            ? solve_for_rest(crimped, coefficients, support, options)
                            : open(crimped, coefficients, support, options);
    require_unbuckled(rest, lattice, positions);
    if (is_compliant) rest.wall_displacement = beyond(wall_stops, rest.radii);

    Deployment result = as_it_is(crimped, rest, wall, device.wire_diameter);
    if (options.lattice == LatticeKind::paper_2020) {
        const BraidLattice crossings = make_lattice(device);
        const LatticeMapping mapping = make_lattice_mapping(lattice, crossings);
        positions = carried_over_rings(mapping, positions);
        result = laid_onto(
            result, rest, mapping,
            lay_out_rings(device, crossings, positions, schedule.twists, centerline, wall, options),
            wall, device);
    }
    result.ring_arc_length = positions;
    result.residual_history = rest.residual_history;
    result.max_force_residual = rest.residual;
    result.force_tolerance = rest.tolerance;
    result.converged = rest.residual <= rest.tolerance;
    result.steps = rest.steps;
    return result;
}

}  // namespace braidzone
