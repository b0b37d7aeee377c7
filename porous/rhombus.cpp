#include "porous/rhombus.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

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
    rhombus.area = area;
    rhombus.spacing_a = area / length_a;
    rhombus.spacing_b = area / length_b;
    rhombus.solidity_a = wire_diameter / rhombus.spacing_a;
    rhombus.solidity_b = wire_diameter / rhombus.spacing_b;
    const bool wires_touch = rhombus.solidity_a >= 1.0 || rhombus.solidity_b >= 1.0;
    rhombus.metal_coverage = wires_touch ? 1.0
                                         : rhombus.solidity_a + rhombus.solidity_b -
                                               rhombus.solidity_a * rhombus.solidity_b;
    rhombus.pore_density = 1.0 / area;
    rhombus.braid_angle = 0.5 * (angle_between_lines(edge_a, circumferential) +
                                 angle_between_lines(edge_b, circumferential));
    rhombus.wire_length = length_a + length_b;
    rhombus.metal_volume =
        0.25 * std::numbers::pi * wire_diameter * wire_diameter * rhombus.wire_length;
    return rhombus;
}

}  // namespace braidzone
