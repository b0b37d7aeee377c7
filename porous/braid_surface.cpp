#include "porous/braid_surface.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace braidzone {

namespace {

/// A side of a rhombus, from the corner with the lower index to the other.
struct Side {
    int from = 0;
    int to = 0;
    std::size_t rhombus = 0;
};

/// For each rhombus, its sides' lengths shared out among the rhombi on both sides of each.
std::vector<double> share_out_wires(const std::vector<Vec3>& points,
                                    const std::vector<std::array<int, 4>>& corners)
{
    std::vector<Side> sides;
    sides.reserve(4 * corners.size());
    for (std::size_t rhombus = 0; rhombus < corners.size(); ++rhombus) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const int p = corners[rhombus][corner];
            const int q = corners[rhombus][(corner + 1) % 4];
            sides.push_back({std::min(p, q), std::max(p, q), rhombus});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
        return std::tie(s.from, s.to, s.rhombus) < std::tie(t.from, t.to, t.rhombus);
    });

    std::vector<double> wire_length(corners.size(), 0.0);
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(first, sides.end(), [&](const Side& side) {
            return side.from != first->from || side.to != first->to;
        });
        const Vec3 arm = points[static_cast<std::size_t>(first->to)] -
                         points[static_cast<std::size_t>(first->from)];
        const double share = arm.norm() / static_cast<double>(last - first);
        for (; first != last; ++first) {
            wire_length[first->rhombus] += share;
        }
    }
    return wire_length;
}

double mean_of_corners(const std::vector<double>& values, const std::array<int, 4>& corners)
{
    double sum = 0.0;
    for (const int corner : corners) {
        sum += values[static_cast<std::size_t>(corner)];
    }
    return 0.25 * sum;
}

template <typename Value>
void append(std::vector<Value>& values, const std::vector<Value>& more)
{
    values.insert(values.end(), more.begin(), more.end());
}

/// Area-weighted sums over some of the rhombi.
struct AreaSums {
    double area = 0.0;
    double density_increase = 0.0;
    double metal_coverage = 0.0;
    double pore_density = 0.0;
};

void add(AreaSums& sums, const BraidSurface& surface, std::size_t rhombus)
{
    const Rhombus& cell = surface.rhombi[rhombus];
    sums.area += cell.area;
    sums.density_increase += cell.area * surface.density_increase[rhombus];
    sums.metal_coverage += cell.area * cell.metal_coverage;
    sums.pore_density += cell.area * cell.pore_density;
}

}  // namespace

BraidSurface make_braid_surface(const std::vector<Vec3>& points,
                                const std::vector<std::array<int, 4>>& corners,
                                double wire_diameter, double force_free_area)
{
    BraidSurface surface;
    surface.points = points;
    surface.corners = corners;
    const std::size_t num_rhombi = corners.size();
    surface.rhombi.reserve(num_rhombi);
    surface.centres.reserve(num_rhombi);
    surface.normals.reserve(num_rhombi);
    surface.density_increase.reserve(num_rhombi);
    for (const std::array<int, 4>& corner : corners) {
        const auto x = [&](std::size_t i) { return points[static_cast<std::size_t>(corner[i])]; };
        const Vec3 edge_a = 0.5 * (x(1) - x(0) + x(2) - x(3));
        const Vec3 edge_b = 0.5 * (x(3) - x(0) + x(2) - x(1));
        surface.rhombi.push_back(measure_rhombus(edge_a, edge_b, wire_diameter, x(3) - x(1)));
        surface.centres.push_back(0.25 * (x(0) + x(1) + x(2) + x(3)));
        surface.normals.push_back(edge_a.cross(edge_b).normalized());
        surface.density_increase.push_back(force_free_area / surface.rhombi.back().area - 1.0);
    }
    surface.contact_pressure.assign(num_rhombi, 0.0);
    surface.wall_distance.assign(num_rhombi, std::numeric_limits<double>::infinity());
    surface.wire_length = share_out_wires(points, corners);
    return surface;
}

BraidSurface make_braid_surface(const Deployment& deployment, const FlowDiverter& device)
{
    const BraidLattice& lattice = deployment.lattice;
    std::vector<std::array<int, 4>> corners;
    corners.reserve(static_cast<std::size_t>(lattice.num_rhombi()));
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            corners.push_back(rhombus_corners(lattice, ring, column));
        }
    }
    const double half_chord =
        lattice.nominal_radius * std::sin(lattice.arm_width / lattice.nominal_radius);
    BraidSurface surface = make_braid_surface(deployment.nodes, corners, device.wire_diameter,
                                              2.0 * lattice.ring_spacing * half_chord);
    for (std::size_t rhombus = 0; rhombus < corners.size(); ++rhombus) {
        surface.contact_pressure[rhombus] =
            mean_of_corners(deployment.contact_pressure, corners[rhombus]);
        surface.wall_distance[rhombus] =
            mean_of_corners(deployment.wall_distance, corners[rhombus]);
    }
    return surface;
}

BraidSurface joined(const BraidSurface& first, const BraidSurface& second)
{
    BraidSurface both = first;
    const int offset = static_cast<int>(first.points.size());
    append(both.points, second.points);
    for (const auto& [a, b, c, d] : second.corners) {
        both.corners.push_back({a + offset, b + offset, c + offset, d + offset});
    }
    append(both.rhombi, second.rhombi);
    append(both.centres, second.centres);
    append(both.normals, second.normals);
    append(both.density_increase, second.density_increase);
    append(both.contact_pressure, second.contact_pressure);
    append(both.wall_distance, second.wall_distance);
    append(both.wire_length, second.wire_length);
    return both;
}

std::vector<NeckPart> neck_parts(const Deployment& deployment,
                                 const std::vector<WallOpening>& openings)
{
    const BraidLattice& lattice = deployment.lattice;
    std::vector<NeckPart> parts(static_cast<std::size_t>(lattice.num_rhombi()), NeckPart::none);
    const WallOpening* found = neck_of(openings);
    if (found == nullptr) return parts;
    const WallOpening& neck = *found;
    const std::vector<char> of_neck = nodes_of({neck}, lattice.num_nodes());
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            int corners_over = 0;
            for (const int corner : rhombus_corners(lattice, ring, column)) {
                corners_over += of_neck[static_cast<std::size_t>(corner)];
            }
            NeckPart& part = parts[static_cast<std::size_t>(lattice.node(ring, column))];
            const bool in_zone = ring + 1 >= neck.distal_ring && ring + 1 <= neck.proximal_ring;
            if (corners_over >= 3) {
                part = NeckPart::over;
            } else if (in_zone) {
                part = NeckPart::opposite;
            }
        }
    }
    return parts;
}

BraidMeasures measure(const BraidSurface& surface, const std::vector<NeckPart>& parts)
{
    AreaSums device, neck, neck_rings;
    BraidMeasures measures;
    for (std::size_t rhombus = 0; rhombus < surface.rhombi.size(); ++rhombus) {
        const NeckPart part = parts.empty() ? NeckPart::none : parts[rhombus];
        add(device, surface, rhombus);
        if (part == NeckPart::over) add(neck, surface, rhombus);
        if (part != NeckPart::none) add(neck_rings, surface, rhombus);
        measures.wire_length += surface.wire_length[rhombus];
        measures.metal_volume += metal_volume(surface, rhombus);
    }
    measures.device_area = device.area;
    if (device.area > 0.0) {
        measures.mean_density_increase = device.density_increase / device.area;
        measures.mean_metal_coverage = device.metal_coverage / device.area;
    }
    if (neck.area > 0.0) {
        measures.mean_density_increase_neck = neck.density_increase / neck.area;
        measures.mean_metal_coverage_neck = neck.metal_coverage / neck.area;
        measures.mean_pore_density_neck = neck.pore_density / neck.area;
    }
    if (neck_rings.area > 0.0) {
        measures.mean_density_increase_neck_rings = neck_rings.density_increase / neck_rings.area;
    }
    return measures;
}

double metal_volume(const BraidSurface& surface, std::size_t rhombus)
{
    const double diameter = surface.rhombi[rhombus].wire_diameter;
    const double cross_section = 0.25 * std::numbers::pi * diameter * diameter;
    return cross_section * surface.wire_length[rhombus];
}

}  // namespace braidzone
