#pragma once

#include "deploy/flow_diverter.hpp"
#include "deploy/radial_spring.hpp"

namespace braidzone {

// The wires of a braid as helical springs (Jedwab and Clerc 1993, J. Appl. Biomater. 4:77-85).
//
// Each wire is an inextensible, linearly elastic rod on a helix; wires do not rub, and the ends of
// the braid are free to move along the axis but do not turn. With b the braid angle from the
// circumference, index 0 for the force-free device, n wires of both families together:
//
//     D = K3 cos b,   K1 = sin 2 b0 / D0,   K2 = 2 cos^2 b0 / D0,   K3 = D0 / cos b0
//     I = pi d^4 / 64,   J = 2 I,   G = E / (2 (1 + nu))
//
// Curvature 2 cos^2 b / D and torsion sin 2b / D of a wire differ from those at rest, which costs
//
//     U = n l [ EI (kappa - kappa0)^2 / 2 + GJ (tau - tau0)^2 / 2 ],   l = L0 / sin b0
//
// and from which every function here follows. Strains stay below d / D0, about 1 %, so that metals
// are elastic and nickel-titanium stays austenitic. Not covered: friction between wires, wires of
// unlike stiffness that share their load unevenly, ends that are welded or looped.
//
// Functions of a diameter take the open range from 0 to `largest_diameter` and throw InputError
// outside it. All but `largest_diameter` and `crossing_node_area` throw InputError if the device
// has no Young's modulus.

/// Diameter at which the wires would lie along the circumference and the length be 0 [m]:
/// D0 sqrt(1 + t^2) = K3.
double largest_diameter(const FlowDiverter& device);

/// Elastic energy U of the whole device, held at a diameter with its ends free [J].
double wire_energy(const FlowDiverter& device, double diameter);

/// Pull along the axis that alone holds the braid at a diameter [N]; positive below nominal, where
/// the braid is longer than at rest:
///
///     F = 2 n [ (GJ/K3) (2 sin b / K3 - K1) - (EI tan b / K3) (2 cos b / K3 - K2) ]
///
/// which is dU/dL.
double axial_force(const FlowDiverter& device, double diameter);

/// Pressure on the outside that alone holds the braid at a diameter [Pa], ends free; positive below
/// nominal diameter:
///
///     p = 2 F / (pi D^2 tan^2 b)
///
/// which is -dU/dD over the half of the lateral area, pi D L / 2. It grows without bound in both
/// stiff limits: as 1 / D in a narrow tube, where the wires are stretched out, and as
/// -1 / tan^2 b near the largest diameter.
double wire_pressure(const FlowDiverter& device, double diameter);

/// Radial force a length of the braid, p pi D [N/m].
double wire_radial_force(const FlowDiverter& device, double diameter);

/// Bending stiffness EI and torsional stiffness GJ of one wire [N m^2].
double wire_bending_rigidity(const FlowDiverter& device);
double wire_torsion_rigidity(const FlowDiverter& device);

/// Area of the force-free device that a crossing stands for [m^2]: n/2 of them around, staggered.
double crossing_node_area(const FlowDiverter& device);

/// The radial spring of a node at the wires' crossings. It stands for two pieces of wire of length
/// l, from one crossing to the next, so that its energy is 2 l / (n l_wire) of the device's:
///
///     c_bending = 2 l EI cos^4 b0 / R0^4,   c_torsion = 2 l GJ cos^4 b0 / R0^4
///
/// with l = pi R0 / (n/2) / cos b0. Over the node's area at force-free spacing its force is
/// `wire_pressure` exactly, up to where the spring leaves its curve (`radial_force`).
RadialSpring crossing_radial_spring(const FlowDiverter& device);

/// Stiffness of a wire against a sideways step from one crossing to the next, EI / l^3 [N/m].
double crossing_bending_stiffness(const FlowDiverter& device);

/// Stiffness of a wire against stretching from one crossing to the next, EA / l [N/m].
double wire_axial_stiffness(const FlowDiverter& device);

}  // namespace braidzone
