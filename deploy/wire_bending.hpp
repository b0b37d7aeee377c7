#pragma once

#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

/// Resistance of the wires to bending out of the device's surface.
///
///     E = sum over wires, over three crossings in a row, of c_bending (r- - 2 r + r+)^2 / 2
///
/// with r the distance of a crossing to the hub of its ring, of a device with a flare or a cone
/// less the force-free radius there: its wires were set in that shape. It vanishes wherever the
/// radius is uniform or tapers evenly, so that it adds nothing to the pressure on a straight wall.
///
/// The paper's lattice has no such term and needs none: its nodes are 15 degrees or more apart. On
/// the lattice of the real crossings a device narrower than nominal is a compressed net, which
/// without bending stiffness folds between one ring and the next. Real wires are stiffer than that:
/// E I / h^3 is about 360 N/m for a 30 um wire at 0.28 mm between crossings.
///
/// @param coefficient  c_bending [N/m]
/// @param radii        |N| distance of each node to the hub of its ring [m]
/// @return E [J]
double bending_energy(const BraidLattice& lattice, double coefficient,
                      const std::vector<double>& radii);

/// Radial force of the bent wires on a node: minus the derivative of the energy with respect to the
/// node's radius [N], positive outwards.
double bending_force(const BraidLattice& lattice, double coefficient,
                     const std::vector<double>& radii, int ring, int column);

/// Adds the radial forces of the bent wires to all nodes at once: those of `bending_force`.
/// @param forces  |N| [N]
/// @return E [J]
double add_bending_forces(const BraidLattice& lattice, double coefficient,
                          const std::vector<double>& radii, std::vector<double>& forces);

}  // namespace braidzone
