#include "deploy/release_spacing.hpp"

#include "deploy/braid_kinematics.hpp"
#include "deploy/ring_centring.hpp"
#include "deploy/ring_planes.hpp"
#include "deploy/wire_jam.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Directions around a ring: where one of them passes from the wall into a sac, the mean changes by
/// 1 / 48 of what it gains.
constexpr int num_directions = 48;

/// Newton's steps for the spacing of free arms: the change of the last is below this part of it.
constexpr double spacing_tolerance = 1e-12;
constexpr int most_rounds = 30;

/// Room for hubs that cut the corner of a bend, along which rings lie further apart than in a
/// straight vessel of the same width, measured on the centerline.
constexpr double bend_allowance = 1.1;

/// Rounds in which the spacing of rings and the tilt of their planes are fitted to each other: the
/// planes of rings that lie further apart turn further.
constexpr int plane_rounds = 2;

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
        braid_left -= centerline.spacing / (bend_allowance * pull * local_spacing(device, radius));
        position = std::max(0.0, position - centerline.spacing);
    }
    return position;
}

/// Angle of a direction in a cross-section [rad].
double direction(int i)
{
    return 2.0 * std::numbers::pi * i / num_directions;
}

/// A place of the table: the ring's plane there, and how it changes along the vessel.
struct Station {
    CrossSection section;
    Vec3 hub_change = Vec3::Zero();       ///< d hub / ds [-]
    Vec3 normal_change = Vec3::Zero();    ///< d normal / ds [1/m]
    Vec3 binormal_change = Vec3::Zero();  ///< [1/m]
};

std::vector<Station> stations_of(const std::vector<CrossSection>& sections,
                                 const std::vector<double>& places)
{
    std::vector<Station> stations;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        const std::size_t after = std::min(i + 1, sections.size() - 1);
        const double step = places[after] - places[before];
        const auto change = [&](Vec3 CrossSection::*axis) {
            return Vec3((sections[after].*axis - sections[before].*axis) / step);
        };
        stations.push_back({sections[i], change(&CrossSection::origin),
                            change(&CrossSection::normal), change(&CrossSection::binormal)});
    }
    return stations;
}

/// Spacing over nominal at which arms keep their length on average around a ring.
/// @param radii  in the directions [m]
/// @param least  at which the wires jam [-]
double free_spacing(const FlowDiverter& device, const Station& station,
                    const std::vector<double>& radii, double least)
{
    const double nominal_width =
        2.0 * std::numbers::pi * device.nominal_radius() / device.num_wires;
    const double nominal_spacing = device.braid_ratio * nominal_width;
    const double rest = std::hypot(nominal_width, nominal_spacing);
    std::vector<Vec3> along, around;
    double mean = 0.0;
    for (int i = 0; i < num_directions; ++i) {
        const double radius = radii[static_cast<std::size_t>(i)];
        const double c = std::cos(direction(i)), s = std::sin(direction(i));
        along.push_back(station.hub_change +
                        radius * (c * station.normal_change + s * station.binormal_change));
        around.push_back(radius / device.nominal_radius() * nominal_width *
                         (c * station.section.binormal - s * station.section.normal));
        mean += radius / num_directions;
    }
    double spacing = nominal_spacing * local_spacing(device, mean);
    for (int round = 0; round < most_rounds; ++round) {
        double length = 0.0, slope = 0.0;
        for (std::size_t i = 0; i < along.size(); ++i) {
            for (const double sense : {1.0, -1.0}) {
                const Vec3 arm = spacing * along[i] + sense * around[i];
                length += arm.norm() / (2.0 * num_directions);
                slope += along[i].dot(arm) / arm.norm() / (2.0 * num_directions);
            }
        }
        const double change = (rest - length) / slope;
        spacing = std::max(spacing + change, least * nominal_spacing);
        if (std::abs(change) <= spacing_tolerance * spacing) break;
    }
    return spacing / nominal_spacing;
}

/// The planes of rings spaced by the table, which do not cross within the lumen.
/// @param sections  at the table's points, across the vessel
std::vector<CrossSection> planes_along(const std::vector<CrossSection>& sections,
                                       const std::vector<SpacingPoint>& table, const WallTree& wall,
                                       const FlowDiverter& device, const BraidLattice& lattice)
{
    std::vector<double> gaps;
    for (std::size_t i = sections.size() - 1; i > 0; --i) {
        const double rings =
            (table[i].arc_length - table[i - 1].arc_length) /
            (0.5 * (table[i].spacing + table[i - 1].spacing) * lattice.ring_spacing);
        gaps.push_back(rings * least_plane_gap(device, lattice));
    }
    std::vector<CrossSection> planes =
        uncrossed_rings({sections.rbegin(), sections.rend()}, wall, device.nominal_radius(), gaps);
    std::reverse(planes.begin(), planes.end());
    return planes;
}

bool is_tilted(const std::vector<CrossSection>& planes, const std::vector<CrossSection>& sections)
{
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (planes[i].tangent != sections[i].tangent) return true;
    }
    return false;
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

/// Rings no nearer than the wires allow; those behind them move on.
std::vector<double> kept_apart(std::vector<double> positions, double least)
{
    double moved = 0.0;
    for (std::size_t ring = 1; ring < positions.size(); ++ring) {
        const double next = positions[ring] - moved;
        const double furthest = positions[ring - 1] - least;
        if (next > furthest) moved += next - furthest;
        positions[ring] = std::min(next, furthest);
    }
    return positions;
}

}  // namespace

std::vector<double> resting_radii(const CrossSection& section, const WallTree& wall,
                                  double nominal_radius)
{
    std::vector<double> radii;
    for (int i = 0; i < num_directions; ++i) {
        const Vec3 ray =
            std::cos(direction(i)) * section.normal + std::sin(direction(i)) * section.binormal;
        const auto hit = wall.first_hit(section.origin, section.origin + nominal_radius * ray);
        radii.push_back(nominal_radius * (hit ? hit->fraction : 1.0));
    }
    return radii;
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
    std::vector<double> places;
    for (int i = 0; i <= num_gaps; ++i)
        places.push_back(std::lerp(proximal, distal, static_cast<double>(i) / num_gaps));

    std::vector<CrossSection> sections;
    if (centred) {
        sections = centred_rings(centerline, wall, places, device.nominal_radius());
    } else {
        for (const double place : places)
            sections.push_back(section_at(centerline, place));
    }
    const double least = least_ring_spacing(device, lattice) / lattice.ring_spacing;
    const auto table_on = [&](const std::vector<CrossSection>& planes) {
        std::vector<SpacingPoint> table;
        const std::vector<Station> stations = stations_of(planes, places);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::vector<double> radii = resting_radii(planes[i], wall, widest_radius(device));
            table.push_back({places[i], free_spacing(device, stations[i], radii, least)});
        }
        return table;
    };
    std::vector<SpacingPoint> table = table_on(sections);
    for (int round = 0; round < plane_rounds; ++round) {
        const auto planes = planes_along(sections, table, wall, device, lattice);
        if (!is_tilted(planes, sections)) break;
        table = table_on(planes);
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
