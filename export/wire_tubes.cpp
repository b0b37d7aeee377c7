#include "export/wire_tubes.hpp"

#include "export/wire_gap.hpp"
#include "export/wire_path.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Between two wires that cross, over the wire diameter. Real wires touch, but solids that touch
/// are neither separate nor one.
constexpr double clearance_ratio = 0.05;

/// Corners of a regular polygon that has the wire's cross-section [m].
double corner_radius(int facets, double wire_diameter)
{
    const double angle = 2.0 * std::numbers::pi / facets;
    return 0.5 * wire_diameter * std::sqrt(angle / std::sin(angle));
}

/// Height of a wire over the braid's surface at its crossings [m].
double crossing_height(const WireTubeOptions& options, double wire_diameter)
{
    return corner_radius(options.facets, wire_diameter) + 0.5 * clearance_ratio * wire_diameter;
}

/// The middle line of a wire with the braid's normals there.
struct WireLine {
    std::vector<Vec3> points;   ///< [m]
    std::vector<Vec3> normals;  ///< unit
};

/// Height of a wire t of the way between two crossings at which it has the given heights: even over
/// the first and the last quarter, a cosine in between. (With a cosine all the way, wires that
/// cross at a small angle meet beside their crossings.)
double height_between(double from, double to, double t)
{
    const double part = std::clamp(2.0 * t - 0.5, 0.0, 1.0);
    return 0.5 * (from + to) + 0.5 * (from - to) * std::cos(std::numbers::pi * part);
}

WireLine wire_line(const BraidLattice& lattice, const InsetBraid& braid, Wire wire,
                   double crossing_height, const WireTubeOptions& options)
{
    const int pieces = options.pieces_per_arm;
    WireLine line{spline_along_wire(lattice, braid.nodes, wire, pieces),
                  spline_along_wire(lattice, braid.normals, wire, pieces)};
    const auto height_at = [&](int ring) {
        const bool right_is_outside = right_handed_is_outside(options.pattern, lattice, ring,
                                                              column_of_wire(lattice, wire, ring));
        return right_is_outside == (wire.family == WireFamily::right_handed) ? crossing_height
                                                                             : -crossing_height;
    };
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const int ring = static_cast<int>(i) / pieces;
        const double t = static_cast<double>(static_cast<int>(i) % pieces) / pieces;
        const double from = height_at(ring);
        const double to = t > 0.0 ? height_at(ring + 1) : from;
        line.normals[i].normalize();
        line.points[i] += height_between(from, to, t) * line.normals[i];
    }
    return line;
}

/// The plane in which two straight pieces of a tube meet.
struct Mitre {
    Vec3 tangent = Vec3::UnitX();  ///< unit, halfway between the directions of the pieces
    Vec3 bend = Vec3::Zero();      ///< unit, in the plane and that of the pieces; 0 if they are one
    double stretch = 0.0;          ///< along it, the section is wider than a piece by this, over 1
};

Mitre mitre_at(const std::vector<Vec3>& points, std::size_t i)
{
    const auto direction = [&](std::size_t piece) {
        return (points[piece + 1] - points[piece]).normalized().eval();
    };
    if (i == 0) return {.tangent = direction(0)};
    if (i + 1 == points.size()) return {.tangent = direction(i - 1)};
    const Vec3 before = direction(i - 1), after = direction(i);
    const Vec3 sum = before + after, difference = after - before;
    // |sum| = 2 cos(kink / 2)
    return {sum.normalized(), difference.stableNormalized(), 2.0 / sum.norm() - 1.0};
}

/// Appends the tube about a line: a ring of corners at each of its points, a fan over each end.
void append_tube(TriangleMesh& mesh, const WireLine& line, int facets, double radius)
{
    const int first = static_cast<int>(mesh.points.size());
    const int num_rings = static_cast<int>(line.points.size());
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Mitre mitre = mitre_at(line.points, i);
        const Vec3 side = mitre.tangent.cross(line.normals[i]).normalized();
        const Vec3 up = side.cross(mitre.tangent);
        for (int facet = 0; facet < facets; ++facet) {
            const double angle = 2.0 * std::numbers::pi * facet / facets;
            const Vec3 offset = radius * (std::cos(angle) * up + std::sin(angle) * side);
            mesh.points.push_back(line.points[i] + offset +
                                  mitre.stretch * offset.dot(mitre.bend) * mitre.bend);
        }
    }
    const auto corner = [&](int ring, int facet) { return first + ring * facets + facet % facets; };
    for (int ring = 0; ring + 1 < num_rings; ++ring) {
        for (int facet = 0; facet < facets; ++facet) {
            const int a = corner(ring, facet), b = corner(ring, facet + 1);
            const int c = corner(ring + 1, facet + 1), d = corner(ring + 1, facet);
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
    const int near_end = static_cast<int>(mesh.points.size()), far_end = near_end + 1;
    mesh.points.push_back(line.points.front());
    mesh.points.push_back(line.points.back());
    for (int facet = 0; facet < facets; ++facet) {
        mesh.triangles.push_back({near_end, corner(0, facet + 1), corner(0, facet)});
        mesh.triangles.push_back(
            {far_end, corner(num_rings - 1, facet), corner(num_rings - 1, facet + 1)});
    }
}

double length_of(const std::vector<Vec3>& points)
{
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        length += (points[i + 1] - points[i]).norm();
    return length;
}

}  // namespace

double half_thickness(const WireTubeOptions& options, double wire_diameter)
{
    return crossing_height(options, wire_diameter) + corner_radius(options.facets, wire_diameter);
}

std::size_t num_wire_triangles(const BraidLattice& lattice, const WireTubeOptions& options)
{
    const auto pieces = static_cast<std::size_t>(lattice.num_rings - 1) *
                        static_cast<std::size_t>(options.pieces_per_arm);
    const auto wires = 2 * static_cast<std::size_t>(lattice.nodes_per_ring);
    return wires * 2 * static_cast<std::size_t>(options.facets) * (pieces + 1);
}

WireTubes make_wire_tubes(const BraidLattice& lattice, const InsetBraid& braid,
                          double wire_diameter, const WireTubeOptions& options)
{
    const double height = crossing_height(options, wire_diameter);
    const std::vector<Wire> wires = wires_of(lattice);
    std::vector<WireLine> lines(wires.size());
    tbb::parallel_for(std::size_t{0}, wires.size(), [&](std::size_t i) {
        lines[i] = wire_line(lattice, braid, wires[i], height, options);
    });

    WireTubes tubes;
    const double radius = corner_radius(options.facets, wire_diameter);
    for (WireLine& line : lines) {
        append_tube(tubes.mesh, line, options.facets, radius);
        tubes.length += length_of(line.points);
        tubes.lines.push_back(std::move(line.points));
    }
    const WireGap gap = smallest_gap(tubes.lines, 4.0 * radius, 2.0 * radius);
    tubes.least_gap = gap.distance - 2.0 * radius;
    tubes.least_gap_place = gap.place;
    tubes.num_overlaps = gap.num_closer;
    return tubes;
}

}  // namespace braidzone
