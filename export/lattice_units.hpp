#pragma once

#include "core/fluid.hpp"
#include "export/lattice_nodes.hpp"

namespace braidzone {

/// Above this velocity in lattice units, a Mach number of 0.35, flow is no longer incompressible.
inline constexpr double highest_velocity_lu = 0.2;

/// What a lattice's time step follows from.
struct LatticeFlowOptions {
    double peak_velocity = 0.6;  ///< largest expected in the vessel [m/s]; > 0
    double velocity_lu = 0.05;   ///< of it, in lattice units; 0 < . <= 0.2
};

/// A proposed time step and the numbers that decide whether it is stable. In lattice units spacing,
/// time step and density are 1:
///
///     dt = u_lu dx / U,   nu_lu = nu dt / dx^2,   tau = 3 nu_lu + 1/2,   Ma = sqrt(3) u_lu
///     a = nu D dt,   b = F dx / 2,   drag per step (a + b |u_lu|) u_lu
struct LatticeUnits {
    double spacing = 0.0;             ///< dx [m]
    double time_step = 0.0;           ///< dt [s]
    double viscosity_lu = 0.0;        ///< nu_lu
    double relaxation_time_lu = 0.0;  ///< tau
    double mach = 0.0;
    double largest_drag_lu = 0.0;     ///< a, over the device's nodes
    double largest_inertia_lu = 0.0;  ///< b, over the device's nodes
};

/// @throws ConfigError if a velocity is out of range
LatticeUnits propose_units(const LatticeNodes& nodes, const Fluid& fluid,
                           const LatticeFlowOptions& options);

}  // namespace braidzone
