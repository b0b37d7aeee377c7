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
    /// Factor from forces of these coefficients to those of the real device [-].
    double force_scale = 1.0;
};

/// The device's coefficients on its lattice, in the units of the paper's code: times `force_scale`
/// they are real. The scale applies to the forces that are reported and leaves the shape as it is;
/// time step and damping are tuned to coefficients of the paper's size.
///
/// An arm's coefficient is that of the crossings. It does not depend on the fineness of a lattice
/// of similar cells. A radial spring stands for the area of its node, so it is scaled with that,
/// and at the ends by the node's share of it. Its rest radius is the ring's.
///
/// An arm of another lattice is scaled so that the sheet is as stiff for the same strain: by the
/// area of a node over the square of an arm's length, relative to the crossings,
///
///     c_surface = c (A / l0^2) / (A / l0^2 of the crossings)
///
/// which is 0.15 c for the paper's lattice, whose arms span six arms of the crossings, and are
/// three times as dense as a net of such wide cells needs to be. Bending goes with A / l0^4: the
/// same energy for the same curvature.
///
/// Forces from springs: the device's own coefficients, the radial one times node area over
/// `reference_node_area`, and the device's own scale.
///
/// Forces from wire theory: the radial spring is `crossing_radial_spring`. The arms are the wires'
/// resistance to being stretched. Wires are practically inextensible (EA / l is about 5e5 N/m), but
/// where rings are locked in planes that the wires would leave, an arm stands for all that a wire
/// does instead of stretching: it slides, bends between crossings, and turns at them. So the arms
/// keep the ratio to the radial spring that the device's own springs have, or if it has none, that
/// of the paper's 4 mm device, 32. At the force-free ring spacing of `release_spacing.hpp` arms
/// bear next to nothing and the ratio does not matter.
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

/// The radial spring of an inner node of a ring, at rest at the ring's own radius.
RadialSpring spring_of_ring(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                            int ring);

/// Force of its springs on a node: minus the gradient of the energy with respect to the node [N].
///
///     F = sum over its arms of c_surface (l - l0) d / l  +  q f(r) e_r
///
/// with d from the node to the other end of the arm, e_r from the hub to the node and f the force
/// of its radial spring. A node on the hub feels no radial force.
Vec3 spring_force(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                  const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings, int ring,
                  int column);

/// Adds the forces of the springs to all nodes at once, each arm measured once: those of
/// `spring_force`, in a third of the time.
/// @param forces  |N| x 3 [N]
/// @return the elastic energy [J]
double add_spring_forces(const BraidLattice& lattice, const SpringCoefficients& coefficients,
                         const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings,
                         std::vector<Vec3>& forces);

/// Force on the hub of a ring that is free to move in the ring's plane: minus the gradient of the
/// energy with respect to the hub, which is the opposite of its radial springs' forces [N].
///
///     F = - sum over the ring's nodes of q f(r) e_r, without its part along the ring's tangent
Vec3 hub_force(const BraidLattice& lattice, const SpringCoefficients& coefficients,
               const std::vector<Vec3>& nodes, const std::vector<CrossSection>& rings, int ring);

/// Largest angular frequency of the lattice for nodes of mass m [1/s]: the time step of the Verlet
/// scheme must stay below 2 / omega.
///
///     omega^2 = (8 c_surface + c_radial + 32 c_bending) / m
///
/// which bounds every mode: neighbours that move in opposite senses along all four arms, and
/// crossings that alternate along both wires.
double largest_frequency(const SpringCoefficients& coefficients, double mass);

}  // namespace braidzone
