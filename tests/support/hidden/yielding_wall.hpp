#pragma once

#include "core/vector.hpp"

#include <functional>

namespace braidzone::hidden {

/// Pressure of a wall over the depth by which it is passed: a bed of springs that stiffen.
///
///     p = (k s + k3 s^3) ds/dg,   s = (g + sqrt(g^2 + d^2)) / 2
///
/// g is the depth, s the part of it beyond the wall, rounded over d so that a minimiser sees a
/// smooth energy. A rigid wall is a stiff one: 1e10 Pa/m yield half a micrometre to the contact
/// pressures here.
struct WallSprings {
    double stiffness = 1e10;   ///< k [Pa/m]
    double stiffening = 0.0;   ///< k3 [Pa/m^3]
    double rounding = 0.5e-6;  ///< d [m]
};

/// Energy of an area [J/m^2] with its first two derivatives by the depth [Pa], [Pa/m].
struct WallEnergy {
    double value = 0.0;
    double pressure = 0.0;
    double slope = 0.0;
};

WallEnergy wall_energy(const WallSprings& springs, double depth);

/// Where a device meets a wall: the depth beyond it at a point [m], negative inside the lumen,
/// about a distance near the wall.
using WallLevel = std::function<double(const Vec3&)>;

}  // namespace braidzone::hidden
