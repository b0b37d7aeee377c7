#pragma once

namespace braidzone {

/// The spring between a node and the hub of its ring: how hard the piece of braid that the node
/// stands for pushes outwards when it is held at a radius r.
///
///     f(r) = c_bending (R0 - r) + c_torsion r (sin b - sin b0) / sin b,   cos b = cos b0 r / R0
///
/// The first part is the spring of Zavodszky et al. 2020 (equation 2, Table 2). It is also exactly
/// what wires that only bend give: the curvature of a helix at radius r, cos^2 b / r, grows
/// linearly with r when the wire keeps its length. The second part is the torsion of those wires,
/// which a measured spring coefficient does not tell apart (`wire_theory.hpp`).
struct RadialSpring {
    double rest_radius = 0.0;  ///< R0 [m]
    double bending = 0.0;      ///< c_bending [N/m]
    double torsion = 0.0;      ///< c_torsion [N/m]
    double braid_ratio = 0.0;  ///< t = tan b0; needed if there is torsion [-]
};

/// Outward force on the node at a radius [N]. Beyond the radius at which sin b has fallen to half
/// of sin b0 the torsion part goes on along its tangent: the braid is about to close up there.
/// @param radius  r [m]; > 0
double radial_force(const RadialSpring& spring, double radius);

/// Energy of the spring [J], 0 at rest; minus its derivative by the radius is the force.
double radial_energy(const RadialSpring& spring, double radius);

/// Stiffness of the spring at a radius, -df/dr [N/m]; negative where it softens.
double radial_stiffness_at(const RadialSpring& spring, double radius);

/// Stiffness of the spring at rest, -df/dr at R0 [N/m]: c_bending + c_torsion / t^2.
double radial_stiffness(const RadialSpring& spring);

/// The same spring at rest at another radius, with the braid angle that the wires have there: that
/// of a ring in a flare.
RadialSpring at_rest_radius(const RadialSpring& spring, double radius);

/// The same spring, `factor` times as strong.
RadialSpring scaled(const RadialSpring& spring, double factor);

}  // namespace braidzone
