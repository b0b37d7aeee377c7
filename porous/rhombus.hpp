#pragma once

#include "core/vector.hpp"

namespace braidzone {

/// Local geometry of a braid of round wires in one pore: the parallelogram between four crossings.
///
///     A = |a x b|,  s_a = d |a| / A,  s_b = d |b| / A
///     metal coverage = s_a + s_b - s_a s_b          (crossing overlap counted once)
///     pore density = 1 / A
///     wire length per area = (|a| + |b|) / A
///     metal volume per area = pi d^2 / 4 (|a| + |b|) / A
///
/// Exact for straight strips of width d while s_a, s_b < 1.
struct Rhombus {
    Vec3 edge_a = Vec3::Zero();   ///< along the right-handed wires [m]
    Vec3 edge_b = Vec3::Zero();   ///< along the left-handed wires [m]
    double area = 0.0;            ///< [m^2]
    double spacing_a = 0.0;       ///< perpendicular distance of the wires along a: A / |a| [m]
    double spacing_b = 0.0;       ///< [m]
    double solidity_a = 0.0;      ///< s_a, wire diameter over spacing [-]
    double solidity_b = 0.0;      ///< [-]
    double metal_coverage = 0.0;  ///< [-]; 1 when the wires of a family touch
    double pore_density = 0.0;    ///< [1/m^2]
    double braid_angle = 0.0;     ///< of the wires from the circumference: half the angle [rad]
    double wire_length = 0.0;     ///< of the cell: |a| + |b| [m]
    double metal_volume = 0.0;    ///< of the cell [m^3]
};

/// The local geometry of a cell.
/// @param edge_a, edge_b   the cell's edges along the two wire families [m]; not parallel
/// @param wire_diameter    d [m]; > 0
/// @param circumferential  direction from which the braid angle is measured; any length but 0.
///        The angle is that between the wires and this direction, mean of both families.
/// @throws InputError if the cell has no area, or the wire diameter is not positive
Rhombus measure_rhombus(const Vec3& edge_a, const Vec3& edge_b, double wire_diameter,
                        const Vec3& circumferential);

}  // namespace braidzone
