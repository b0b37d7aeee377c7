#include "porous/rhombus.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Angle between two lines, 0 to pi/2 [rad].
double angle_between_lines(const Vec3& u, const Vec3& v)
{
    return std::atan2(u.cross(v).norm(), std::abs(u.dot(v)));
}

/// Below this sine of the crossing angle two edges are parallel to round-off.
constexpr double parallel_sine = 1e-9;

}  // namespace

Rhombus measure_rhombus(const Vec3& edge_a, const Vec3& edge_b, double wire_diameter,
                        const Vec3& circumferential)
{
    if (!(wire_diameter > 0.0)) {
        throw InputError(
            fmt::format("wire diameter {:.6g} m of a braid cell: must be positive", wire_diameter));
    }
    const double length_a = edge_a.norm();
    const double length_b = edge_b.norm();
    const double area = edge_a.cross(edge_b).norm();
    if (!(area > parallel_sine * length_a * length_b)) {
        throw InputError(
            fmt::format("braid cell without area: edges of {:.6g} m and {:.6g} m span {:.6g} m^2",
                        length_a, length_b, area));
    }

    Rhombus rhombus;
    rhombus.edge_a = edge_a;
    rhombus.edge_b = edge_b;
    rhombus.wire_diameter = wire_diameter;
    rhombus.area = area;
    rhombus.spacing_a = area / length_a;
    rhombus.spacing_b = area / length_b;
    rhombus.solidity_a = wire_diameter / rhombus.spacing_a;
    rhombus.solidity_b = wire_diameter / rhombus.spacing_b;
    const double open_a = 1.0 - rhombus.solidity_a, open_b = 1.0 - rhombus.solidity_b;
    rhombus.metal_coverage = 1.0;
    if (open_a > 0.0 && open_b > 0.0) {
        rhombus.metal_coverage = 1.0 - open_a * open_b;
        rhombus.pore_area = open_a * open_b * area;
        rhombus.inscribed_diameter = std::min(rhombus.spacing_a, rhombus.spacing_b) - wire_diameter;
        // The pore's edges are what the other family leaves open of the cell's.
        const double perimeter = 2.0 * (open_b * length_a + open_a * length_b);
        rhombus.hydraulic_diameter = 4.0 * rhombus.pore_area / perimeter;
    }
    rhombus.pore_density = 1.0 / area;
    rhombus.braid_angle = 0.5 * (angle_between_lines(edge_a, circumferential) +
                                 angle_between_lines(edge_b, circumferential));
    rhombus.crossing_angle = angle_between_lines(edge_a, edge_b);
    rhombus.jamming_angle = std::asin(std::min(1.0, wire_diameter / std::min(length_a, length_b)));
    rhombus.wire_length = length_a + length_b;
    rhombus.metal_volume =
        0.25 * std::numbers::pi * wire_diameter * wire_diameter * rhombus.wire_length;
    return rhombus;
}

double mean_solidity(const Rhombus& rhombus)
{
    return 0.5 * (rhombus.solidity_a + rhombus.solidity_b);
}

double densest_solidity(const Rhombus& rhombus)
{
    return std::max(rhombus.solidity_a, rhombus.solidity_b);
}

double surface_porosity(const Rhombus& rhombus)
{
    return 1.0 - rhombus.metal_coverage;
}

double wire_length_per_area(const Rhombus& rhombus)
{
    return rhombus.wire_length / rhombus.area;
}

double metal_volume_per_area(const Rhombus& rhombus)
{
    return rhombus.metal_volume / rhombus.area;
}

double layer_void_fraction(const Rhombus& rhombus)
{
    return 1.0 - metal_volume_per_area(rhombus) / (2.0 * rhombus.wire_diameter);
}

}  // namespace braidzone
