#include "deploy/deployment.hpp"

#include "core/error.hpp"
#include "deploy/crimped_braid.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/equation_of_motion.hpp"
#include "deploy/ring_centring.hpp"
#include "deploy/spring_forces.hpp"
#include "deploy/wall_contact.hpp"
#include "deploy/wire_bending.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

/// Distance from the wall at which nodes are held, over the nominal radius: 1 um for a 4 mm device,
/// far below a wire's radius and far above the rounding of single-precision surfaces.
constexpr double contact_offset_ratio = 5e-4;

/// How far the wall is looked for along a ray, over the nominal radius. No braid opens beyond
/// R0 sqrt(1 + t^2), 1.14 R0 for the steepest of the library; the rest is room for the swing.
constexpr double reach_ratio = 2.0;

std::vector<CrossSection> sections_at(const Centerline& centerline,
                                      const std::vector<double>& arc_lengths)
{
    std::vector<CrossSection> sections;
    for (double arc_length : arc_lengths)
        sections.push_back(section_at(centerline, arc_length));
    return sections;
}

void require_device_on_centerline(const Centerline& centerline,
                                  const std::vector<double>& positions)
{
    const double proximal = positions.back(), distal = positions.front();
    if (!(proximal >= 0.0 && distal <= centerline.length())) {
        throw GeometryError(fmt::format(
            "the device would lie from {:.6g} to {:.6g} mm along the centerline, which runs from 0 "
            "to {:.6g} mm: move deployment.landing_distal, or take a shorter device",
            1e3 * proximal, 1e3 * distal, 1e3 * centerline.length()));
    }
}

void require_room_for_catheter(const CrimpedBraid& braid, const std::vector<double>& positions,
                               const WallTree& wall)
{
    for (std::size_t ring = 0; ring < braid.rings.size(); ++ring) {
        const Vec3& hub = braid.rings[ring].origin;
        const double room = wall.contains(hub) ? wall.nearest(hub).distance : 0.0;
        if (!(room > braid.radius)) {
            throw GeometryError(fmt::format(
                "at {:.6g} mm along the centerline the wall is {:.6g} mm away; the catheter of "
                "{:.6g} mm diameter does not pass",
                1e3 * positions[ring], 1e3 * room, 2e3 * braid.radius));
        }
    }
}

/// Largest nominal over mean vessel diameter. Labels allow a few tenths of a millimetre; at twice
/// the diameter a 4 mm device would have to lengthen 2.4 times to lie free of force.
constexpr double largest_oversize = 2.0;

void require_fitting_diameter(const FlowDiverter& device, const std::vector<CrossSection>& rings)
{
    double smallest = rings.front().inscribed_radius, sum = 0.0;
    for (const CrossSection& ring : rings) {
        smallest = std::min(smallest, ring.inscribed_radius);
        sum += ring.inscribed_radius;
    }
    const double mean = sum / static_cast<double>(rings.size());
    if (!(device.nominal_radius() > smallest)) {
        throw GeometryError(fmt::format(
            "device.diameter = {:.6g} mm is too small: the vessel is at least {:.6g} mm wide all "
            "along the device, so that nothing would hold it",
            1e3 * device.nominal_diameter, 2e3 * smallest));
    }
    if (!(device.nominal_radius() < largest_oversize * mean)) {
        throw GeometryError(fmt::format(
            "device.diameter = {:.6g} mm is too large: the vessel is {:.6g} mm wide on average "
            "along the device; allowed are {} times that",
            1e3 * device.nominal_diameter, 2e3 * mean, largest_oversize));
    }
}

/// The lattice in motion: released rings move, the others wait at the catheter's radius. A node
/// moves along its ray.
class OpeningBraid {
public:
    OpeningBraid(const CrimpedBraid& braid, const SpringCoefficients& coefficients,
                 const VerletScheme& scheme, std::vector<double> wall_stops)
        : braid_(braid),
          lattice_(braid_.lattice),
          coefficients_(coefficients),
          scheme_(scheme),
          stops_(std::move(wall_stops)),
          radii_(braid_.rays.size(), braid_.radius),
          displacements_(radii_.size(), 0.0),
          spring_forces_(radii_.size(), 0.0),
          forces_(radii_.size(), 0.0),
          held_(radii_.size(), 0),
          moved_(braid_.rings.size() + 2 * reach, 0)
    {
        nodes_.reserve(radii_.size());
        for (int node = 0; node < lattice_.num_nodes(); ++node) {
            nodes_.push_back(on_ray(braid_, node, braid_.radius));
        }
    }

    void release_next_ring() { mark_moved(num_released_++); }

    bool all_released() const { return num_released_ == lattice_.num_rings; }

    /// One time step of all released rings.
    void step()
    {
        const std::vector<char> awake = awake_rings();
        for (int ring = 0; ring < num_released_; ++ring) {
            if (awake[index(ring)]) update_forces(ring);
        }
        std::fill(moved_.begin(), moved_.end(), char{0});
        for (int ring = 0; ring < num_released_; ++ring) {
            if (awake[index(ring)]) move(ring);
        }
    }

    /// Largest force on a released node that is free to move [N], counting the kinetic energy
    /// that is still in it: a node of speed v swings up to the force v sqrt(m c_radial).
    double largest_residual() const
    {
        const double per_displacement =
            std::sqrt(scheme_.mass * radial_stiffness(coefficients_.radial)) / scheme_.time_step;
        double largest = 0.0;
        for (int node = 0; node < num_released_ * lattice_.nodes_per_ring; ++node) {
            const std::size_t i = index(node);
            if (held_[i]) continue;
            largest = std::max(
                {largest, std::abs(forces_[i]), per_displacement * std::abs(displacements_[i])});
        }
        return largest;
    }

    const std::vector<Vec3>& nodes() const { return nodes_; }
    /// Radial force of each node's springs [N], outwards; without the bending of the wires.
    const std::vector<double>& spring_forces() const { return spring_forces_; }

private:
    /// Rings on either side that the force on a ring depends on.
    static constexpr int reach = 2;

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    void mark_moved(int ring) { moved_[index(ring + reach)] = 1; }

    /// A ring needs a step if it or a neighbour moved in the last one; otherwise nothing about it
    /// has changed. This makes the cost that of the opening front and of the free nodes.
    std::vector<char> awake_rings() const
    {
        std::vector<char> awake(index(num_released_));
        for (int ring = 0; ring < num_released_; ++ring) {
            const auto first = moved_.begin() + ring;
            awake[index(ring)] =
                std::any_of(first, first + 2 * reach + 1, [](char moved) { return moved != 0; });
        }
        return awake;
    }

    void update_forces(int ring)
    {
        for (int column = 0; column < lattice_.nodes_per_ring; ++column) {
            const std::size_t i = index(lattice_.node(ring, column));
            spring_forces_[i] = braid_.rays[i].dot(
                spring_force(lattice_, coefficients_, nodes_, braid_.rings, ring, column));
            forces_[i] = spring_forces_[i] +
                         bending_force(lattice_, coefficients_.bending, radii_, ring, column);
        }
    }

    void move(int ring)
    {
        for (int column = 0; column < lattice_.nodes_per_ring; ++column) {
            const int node = lattice_.node(ring, column);
            const std::size_t i = index(node);
            if (held_[i] && forces_[i] >= 0.0) continue;
            displacements_[i] = next_displacement(scheme_, displacements_[i], forces_[i]);
            radii_[i] += displacements_[i];
            held_[i] = radii_[i] >= stops_[i];
            if (held_[i]) {
                radii_[i] = stops_[i];
                displacements_[i] = 0.0;
            }
            nodes_[i] = on_ray(braid_, node, radii_[i]);
            mark_moved(ring);
        }
    }

    const CrimpedBraid& braid_;
    const BraidLattice& lattice_;
    SpringCoefficients coefficients_;
    VerletScheme scheme_;
    std::vector<double> stops_;          ///< see `wall_stops`
    std::vector<double> radii_;          ///< of each node on its ray [m]
    std::vector<Vec3> nodes_;            ///< [m]
    std::vector<double> displacements_;  ///< along the ray in the last step [m]
    std::vector<double> spring_forces_;  ///< along the ray, at the last step's start [N]
    std::vector<double> forces_;         ///< the same with bending [N]
    std::vector<char> held_;             ///< 1 for a node at its stop
    std::vector<char> moved_;            ///< for ring k at k + reach, so that the ends need no case
    int num_released_ = 0;
};

}  // namespace

Deployment deploy(const FlowDiverter& device, const Centerline& centerline, const WallTree& wall,
                  double landing_distal, const ReleaseSchedule& schedule,
                  const DeployOptions& options)
{
    validate(schedule);
    const BraidLattice lattice = make_lattice(device);
    const std::vector<double> positions =
        ring_positions(schedule, landing_distal, lattice.ring_spacing, lattice.num_rings);
    require_device_on_centerline(centerline, positions);
    const std::vector<CrossSection> rings =
        options.centre_rings ? centred_rings(centerline, wall, positions, lattice.nominal_radius)
                             : sections_at(centerline, positions);
    const CrimpedBraid crimped = crimp(lattice, rings, 0.5 * device.catheter_diameter);
    require_room_for_catheter(crimped, positions, wall);
    require_fitting_diameter(device, crimped.rings);

    const SpringCoefficients coefficients =
        spring_coefficients(device, lattice, options.bending_ratio);
    VerletScheme scheme{.damping = options.damping};
    scheme.time_step = options.time_step_ratio * 2.0 / largest_frequency(coefficients, scheme.mass);
    OpeningBraid braid(crimped, coefficients, scheme,
                       wall_stops(crimped, wall, reach_ratio * lattice.nominal_radius,
                                  contact_offset_ratio * lattice.nominal_radius));

    Deployment result;
    while (!braid.all_released()) {
        braid.release_next_ring();
        for (int i = 0; i < options.release_interval; ++i, ++result.steps)
            braid.step();
    }
    const double tolerance =
        options.residual_tolerance * radial_stiffness(coefficients.radial) * lattice.nominal_radius;
    const int last_step = result.steps + options.max_settling_steps;
    while (braid.largest_residual() > tolerance && result.steps < last_step) {
        braid.step();
        ++result.steps;
    }

    result.lattice = lattice;
    result.rings = crimped.rings;
    result.ring_arc_length = positions;
    result.nodes = braid.nodes();
    const std::vector<double> areas = node_areas(lattice, result.nodes);
    for (std::size_t i = 0; i < result.nodes.size(); ++i) {
        result.wall_distance.push_back(wall.nearest(result.nodes[i]).distance);
        result.in_contact.push_back(result.wall_distance[i] <= 0.5 * device.wire_diameter ? 1 : 0);
        const double pressing = std::max(0.0, device.force_scale * braid.spring_forces()[i]);
        result.contact_force.push_back(result.in_contact[i] ? pressing : 0.0);
        result.contact_pressure.push_back(result.contact_force[i] / areas[i]);
    }
    result.max_force_residual = device.force_scale * braid.largest_residual();
    result.force_tolerance = device.force_scale * tolerance;
    result.converged = result.max_force_residual <= result.force_tolerance;
    return result;
}

}  // namespace braidzone
