#pragma once

#include "deploy/braid_lattice.hpp"
#include "deploy/radial_spring.hpp"
#include "deploy/ring_band_matrix.hpp"

#include <vector>

namespace braidzone {

/// A braid as a network of continuous wires in space. Its nodes are the lattice's crossings, where
/// two wires are joined and free to pivot.
///
///     E = sum over arms of k_a (l - l0)^2 / 2
///       + sum over wires, over three crossings in a row, of
///             k_b | x- - 2 x + x+  +  2 (1 - cos(pi / n)) (x - h) |^2 / 2
///       + sum over nodes of q e(r),   r = | x - h |
///
/// h is the hub of the node's ring, the mean of its nodes. The second term is the bending of the
/// wires: it vanishes for the helices of a uniform tube of any radius and spacing, whose second
/// difference points to the axis. What such helices do to the wires, bending and torsion against
/// their natural shape, is the energy e of the radial spring. So a straight tube feels exactly the
/// radial spring, and everything that is not a straight tube the stiffness of the wires. No
/// direction enters but those of the nodes: the energy is the same however the device lies.
struct WireNetwork {
    BraidLattice lattice;
    double axial_stiffness = 0.0;    ///< k_a, of an arm [N/m]
    double bending_stiffness = 0.0;  ///< k_b [N/m]
    RadialSpring radial;             ///< of an inner node, at the nominal rest radius
};

/// A stretch of rings, from `first` up to but without `end`.
struct RingRange {
    int first = 0;
    int end = 0;
    int size() const { return end - first; }
};

/// Shape of a network.
struct NetworkShape {
    std::vector<Vec3> nodes;  ///< |N| x 3 [m]
    int num_rings = 0;        ///< that exist: the nodes of further rings count for nothing
};

/// Energy of all terms that depend on the nodes of the stretch [J].
double network_energy(const WireNetwork& network, const NetworkShape& shape, RingRange active);

/// Gradient of the energy with respect to the nodes of the stretch [N]: minus the force on them.
/// One vector for each node of the stretch.
std::vector<Vec3> network_gradient(const WireNetwork& network, const NetworkShape& shape,
                                   RingRange active);

/// Adds the second derivatives with respect to the nodes of the stretch, without the parts that
/// would make the matrix indefinite (the sideways instability of compressed arms, the softening of
/// radial springs) and without those that couple all nodes of a ring through its hub.
void add_network_hessian(const WireNetwork& network, const NetworkShape& shape, RingRange active,
                         RingBandMatrix& hessian);

/// Longest change of length of an arm over its rest length [-], over the rings that exist.
double largest_arm_strain(const WireNetwork& network, const NetworkShape& shape);

}  // namespace braidzone
