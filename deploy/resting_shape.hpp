#pragma once

#include "deploy/crimped_braid.hpp"
#include "deploy/spring_forces.hpp"
#include "deploy/wall_contact.hpp"

#include <vector>

namespace braidzone {

/// A braid at rest in its supports, in the units of the coefficients.
struct RestingShape {
    std::vector<double> radii;          ///< |N| distance to the hub along the ray [m]
    std::vector<double> spring_forces;  ///< |N| radial, outwards, without the wires' bending [N]
    double residual = 0.0;              ///< largest force on a node that is free to move [N]
    int iterations = 0;
    bool is_at_rest = false;  ///< the residual is within the tolerance, and the shape is stable
};

/// Finds the shape at which a braid whose rings are locked in their planes comes to rest, without
/// the motion that leads there: radii r that minimise the energy of springs, bent wires and
/// compliant wall,
///
///     min E(r)   subject to   r <= stop,
///
/// by a projected Newton method. Nodes that are pressed on their stops are held, the step of the
/// others solves H dr = f with H the Hessian of E over them (`spring_forces.hpp`,
/// `wire_bending.hpp`), where that is not positive definite without the softening of compressed
/// arms; it is cut off at the stops and halved until the energy falls.
///
/// It is the shape that the damped motion of `opening_braid.hpp` ends in, found in about ten
/// iterations: where the wall holds a node and no friction lets it slide, the way there leaves no
/// trace. A braid that folds has several shapes at rest; which one is found may differ there.
/// @param tolerance  largest force on a free node [N]
RestingShape find_resting_shape(const CrimpedBraid& braid, const SpringCoefficients& coefficients,
                                const WallSupport& support, double tolerance,
                                int max_iterations = 100);

}  // namespace braidzone
