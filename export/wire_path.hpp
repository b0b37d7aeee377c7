#pragma once

#include "core/vector.hpp"
#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

/// The two families of a braid's wires.
enum class WireFamily { right_handed = 0, left_handed = 1 };

/// One wire of a braid: 0 to n - 1 in its family.
struct Wire {
    WireFamily family = WireFamily::right_handed;
    int number = 0;
};

/// All wires, right-handed ones first.
std::vector<Wire> wires_of(const BraidLattice& lattice);

/// Column of a wire's crossing in a ring: right-handed wires pass from (k, j) to (k+1, j-1),
/// left-handed ones from (k, j) to (k+1, j).
int column_of_wire(const BraidLattice& lattice, Wire wire, int ring);

/// Values along a wire, out of those at its crossings, by a Catmull-Rom spline through them
/// (Catmull and Rom 1974); before the first and after the last crossing they go on straight.
/// @param of_nodes        |N| x 3, one for each node of the lattice
/// @param pieces_per_arm  into which each stretch between two crossings is cut; >= 1
/// @return num_rings - 1 times `pieces_per_arm` values, and one for the last crossing
std::vector<Vec3> spline_along_wire(const BraidLattice& lattice, const std::vector<Vec3>& of_nodes,
                                    Wire wire, int pieces_per_arm);

/// Coordinates of the same places on the surface of the force-free device, as `surface_coordinates`
/// of the nodes [m].
std::vector<Vec2> surface_coordinates_along_wire(const BraidLattice& lattice, Wire wire,
                                                 int pieces_per_arm);

}  // namespace braidzone
