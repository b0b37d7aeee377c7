#include "deploy/release_spacing.hpp"

#include "deploy/braid_kinematics.hpp"
#include "deploy/ring_centring.hpp"
#include "deploy/wire_jam.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Directions around a ring: where one of them passes from the wall into a sac, the mean changes by
/// 1 / 48 of what it gains.
constexpr int num_directions = 48;

/// Widest radius at rest: that of a flare, or R0.
double widest_radius(const FlowDiverter& device)
{
    return device.nominal_radius() + std::max({0.0, device.distal_flare, device.proximal_flare});
}

double local_spacing(const FlowDiverter& device, double radius)
{
    return length_ratio(device.braid_ratio,
                        std::min(radius, widest_radius(device)) / device.nominal_radius());
}

/// Arc length at which the device ends at the latest [m]: where it would end if the vessel were
/// nowhere wider than its inscribed sphere, since the radius at rest is not smaller.
double furthest_end(const FlowDiverter& device, const Centerline& centerline,
                    const ReleaseSchedule& schedule, double landing_distal, double nominal_length)
{
    double pull = 1.0;
    for (const PushPull& window : schedule.windows)
        pull = std::max(pull, window.spacing);
    // One station beyond the end, so that the table covers it whatever the rounding.
    double braid_left = nominal_length + centerline.spacing;
    double position = std::clamp(landing_distal, 0.0, centerline.length());
    while (braid_left > 0.0 && position > 0.0) {
        const double radius = section_at(centerline, position).inscribed_radius;
        braid_left -= centerline.spacing / (pull * local_spacing(device, radius));
        position = std::max(0.0, position - centerline.spacing);
    }
    return position;
}

/// Where the schedule wants the rings, jammed or not [m].
std::vector<double> wanted_positions(const FlowDiverter& device, const BraidLattice& lattice,
                                     const Centerline& centerline, const WallTree& wall,
                                     const ReleaseSchedule& schedule, double landing_distal,
                                     bool centred)
{
    std::vector<double> nominal;
    for (int ring = 0; ring + 1 < lattice.num_rings; ++ring)
        nominal.push_back(lattice.gap_spacing(ring));
    if (schedule.sliding == 0.0) return ring_positions(schedule, landing_distal, nominal);

    ReleaseSchedule held = schedule;
    held.table =
        force_free_spacing(device, lattice, centerline, wall, schedule, landing_distal, centred);
    if (lattice.gap_spacings.empty()) {
        for (SpacingPoint& point : held.table)
            point.spacing = std::lerp(1.0, point.spacing, schedule.sliding);
        return ring_positions(held, landing_distal, nominal);
    }
    // The arms of a flare are those of the braid: where the wall holds it, it is spaced as the
    // braid is, else as at rest. Of the two radii the smaller counts, so the longer spacing.
    std::vector<double> positions = {landing_distal};
    for (const double at_rest : nominal) {
        const double place = positions.back();
        const double stuck = ring_positions(schedule, place, {at_rest}).back();
        const double free = ring_positions(held, place, {lattice.ring_spacing}).back();
        positions.push_back(std::lerp(stuck, std::min(free, stuck), schedule.sliding));
    }
    return positions;
}

/// Rings no nearer than their wires allow; those behind them move on.
std::vector<double> kept_apart(std::vector<double> positions, double least)
{
    double moved = 0.0;
    for (std::size_t ring = 1; ring < positions.size(); ++ring) {
        const double wanted = positions[ring] - moved;
        positions[ring] = std::min(wanted, positions[ring - 1] - least);
        moved += wanted - positions[ring];
    }
    return positions;
}

}  // namespace

double resting_radius(const CrossSection& section, const WallTree& wall, double nominal_radius)
{
    double sum = 0.0;
    for (int i = 0; i < num_directions; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / num_directions;
        const Vec3 ray = std::cos(angle) * section.normal + std::sin(angle) * section.binormal;
        const auto hit = wall.first_hit(section.origin, section.origin + nominal_radius * ray);
        sum += hit ? hit->fraction : 1.0;
    }
    return nominal_radius * sum / num_directions;
}

std::vector<SpacingPoint> force_free_spacing(const FlowDiverter& device,
                                             const BraidLattice& lattice,
                                             const Centerline& centerline, const WallTree& wall,
                                             const ReleaseSchedule& schedule, double landing_distal,
                                             bool centred)
{
    const double distal = std::clamp(landing_distal, 0.0, centerline.length());
    const double proximal = furthest_end(device, centerline, schedule, landing_distal,
                                         lattice.ring_spacing * (lattice.num_rings - 1));
    const int num_gaps =
        std::max(1, static_cast<int>(std::ceil((distal - proximal) / lattice.ring_spacing)));
    std::vector<double> stations;
    for (int i = 0; i <= num_gaps; ++i)
        stations.push_back(std::lerp(proximal, distal, static_cast<double>(i) / num_gaps));

    std::vector<CrossSection> sections;
    if (centred) {
        sections = centred_rings(centerline, wall, stations, device.nominal_radius());
    } else {
        for (const double station : stations)
            sections.push_back(section_at(centerline, station));
    }
    std::vector<SpacingPoint> table;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const double radius = resting_radius(sections[i], wall, widest_radius(device));
        table.push_back({stations[i], local_spacing(device, radius)});
    }
    return table;
}

std::vector<double> release_positions(const FlowDiverter& device, const BraidLattice& lattice,
                                      const Centerline& centerline, const WallTree& wall,
                                      const ReleaseSchedule& schedule, double landing_distal,
                                      bool centred)
{
    return kept_apart(
        wanted_positions(device, lattice, centerline, wall, schedule, landing_distal, centred),
        least_plane_gap(device, lattice));
}

}  // namespace braidzone
