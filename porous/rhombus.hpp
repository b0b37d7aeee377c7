#pragma once

#include "core/vector.hpp"

namespace braidzone {

/// Local geometry of a braid of round wires in one pore: the parallelogram between four crossings.
///
///     A = |a x b|,  p_a = A / |a|,  s_a = d / p_a,  sin(th) = A / (|a| |b|)
///     metal coverage = s_a + s_b - s_a s_b          (crossing overlap counted once)
///     pore area = (1 - s_a) (1 - s_b) A             (a parallelogram of |a| - d / sin(th), alike
///     b) inscribed circle = min(p_a, p_b) - d          (diameter) hydraulic diameter = 4 pore area
///     / pore perimeter pore density = 1 / A wire length = |a| + |b|,  metal volume = pi d^2 / 4
///     (|a| + |b|)
///
/// Exact for straight strips of width d while s_a, s_b < 1. At 1 the wires of a family touch: the
/// braid is jammed.
struct Rhombus {
    Vec3 edge_a = Vec3::Zero();       ///< along the right-handed wires [m]
    Vec3 edge_b = Vec3::Zero();       ///< along the left-handed wires [m]
    double wire_diameter = 0.0;       ///< d [m]
    double area = 0.0;                ///< A [m^2]
    double spacing_a = 0.0;           ///< perpendicular distance of the wires along a [m]
    double spacing_b = 0.0;           ///< [m]
    double solidity_a = 0.0;          ///< s_a, wire diameter over spacing [-]
    double solidity_b = 0.0;          ///< [-]
    double metal_coverage = 0.0;      ///< [-]; 1 when the wires of a family touch
    double pore_area = 0.0;           ///< open area [m^2]; 0 when the wires of a family touch
    double inscribed_diameter = 0.0;  ///< of the largest circle in the pore [m]; 0 alike
    double hydraulic_diameter = 0.0;  ///< of the pore [m]; 0 alike
    double pore_density = 0.0;        ///< [1/m^2]
    double braid_angle = 0.0;         ///< of the wires from the circumference: half the angle [rad]
    double crossing_angle = 0.0;      ///< th, between the wires, 0 to pi/2 [rad]
    double jamming_angle = 0.0;  ///< th at which wires touch if the edges keep their lengths [rad]
    double wire_length = 0.0;    ///< of the cell [m]
    double metal_volume = 0.0;   ///< of the cell [m^3]
};

/// The local geometry of a cell.
/// @param edge_a, edge_b   the cell's edges along the two wire families [m]; not parallel
/// @param wire_diameter    d [m]; > 0
/// @param circumferential  direction from which the braid angle is measured; any length but 0.
///        The angle is that between the wires and this direction, mean of both families.
/// @throws InputError if the cell has no area, or the wire diameter is not positive
Rhombus measure_rhombus(const Vec3& edge_a, const Vec3& edge_b, double wire_diameter,
                        const Vec3& circumferential);

/// Mean solidity of both families, (s_a + s_b) / 2 [-].
double mean_solidity(const Rhombus& rhombus);

/// Solidity of the denser family [-]; 1 when its wires touch.
double densest_solidity(const Rhombus& rhombus);

/// Share of the sheet that is open, 1 - metal coverage [-]. A property of the sheet: no void
/// fraction.
double surface_porosity(const Rhombus& rhombus);

/// Wire length per area of the sheet, (|a| + |b|) / A [1/m].
double wire_length_per_area(const Rhombus& rhombus);

/// Metal volume per area of the sheet, pi d^2 / 4 times the wire length per area [m].
double metal_volume_per_area(const Rhombus& rhombus);

/// Share of voids in a layer of two wire diameters, as thick as the crossings [-]:
///
///     1 - metal volume per area / (2 d)
///
/// What correlations for stacks and beds take for their void fraction.
double layer_void_fraction(const Rhombus& rhombus);

}  // namespace braidzone
