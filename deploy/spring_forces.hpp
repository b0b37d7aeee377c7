#pragma once

#include "core/centerline.hpp"
#include "deploy/braid_lattice.hpp"
#include "deploy/flow_diverter.hpp"
#include "deploy/radial_spring.hpp"

#include <vector>

namespace braidzone {

/// Coefficients of the lattice's springs (Zavodszky et al. 2020, equation 2 and Table 2).
struct SpringCoefficients {
    double surface = 0.0;  ///< c_surface, of an arm [N/m]
    RadialSpring radial;   ///< of an inner node
    double bending = 0.0;  ///< c_bending, of a wire between three crossings [N/m]
};

/// The device's coefficients on its lattice.
///
/// An arm's coefficient does not depend on the fineness of a lattice of similar cells. A radial
/// spring stands for the area of its node, so the coefficient of the reference lattice is scaled by
/// node area over `reference_node_area`, and at the ends by the node's share of it. The force scale
/// is not included: it is applied to the forces that are reported, and leaves the shape as it is.
/// @param bending_ratio  c_bending over c_surface [-]; >= 0, see `wire_bending.hpp`
SpringCoefficients spring_coefficients(const FlowDiverter& device, const BraidLattice& lattice,
                                       double bending_ratio);

/// Elastic energy of the lattice [J]:
///
///     E = sum over arms of c_surface (l - l0)^2 / 2 + sum over nodes of q e(r)
///
/// with l the length of the arm, r the distance of the node to the hub of its ring, e the energy of
/// its radial spring (`radial_spring.hpp`) and q the share of `BraidLattice::area_share`.
/// @param nodes  |N| x 3 [m]
/// @param rings  one for each ring; the origin is the hub
double elastic_energy(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                      const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings);

/// Force of its springs on a node: minus the gradient of the energy with respect to the node [N].
///
///     F = sum over its arms of c_surface (l - l0) d / l  +  q f(r) e_r
///
/// with d from the node to the other end of the arm, e_r from the hub to the node and f the force
/// of its radial spring. A node on the
/// hub feels no radial force.
Vec3 spring_force(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                  const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings, int ring,
                  int column);

/// Largest angular frequency of the lattice for nodes of mass m [1/s]: the time step of the Verlet
/// scheme must stay below 2 / omega.
///
///     omega^2 = (8 c_surface + c_radial + 32 c_bending) / m
///
/// which bounds every mode: neighbours that move in opposite senses along all four arms, and
/// crossings that alternate along both wires.
double largest_frequency(const SpringCoefficients& coefficients, double mass);

}  // namespace braidzone
