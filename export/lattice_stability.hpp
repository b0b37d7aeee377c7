#pragma once

#include "core/fluid.hpp"
#include "export/lattice_nodes.hpp"
#include "export/lattice_targets.hpp"
#include "export/lattice_units.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// Units with which a target is stable, and what they change of the given ones.
struct StableUnits {
    double spacing = 0.0;        ///< [m]
    double peak_velocity = 0.0;  ///< [m/s]
    double velocity_lu = 0.0;
    double time_step = 0.0;  ///< [s]
    std::string changes;     ///< keys with their values; empty if the given ones are stable
};

/// Whether a target is stable with the units that it uses, and the nearest ones with which it is.
struct TargetStability {
    LatticeTarget target{};
    double time_step = 0.0;    ///< [s]
    double velocity_lu = 0.0;  ///< at its peak
    double relaxation_time_lu = 0.0;
    double largest_drag_lu = 0.0;     ///< a = nu D dt of the fullest node; 0 if it takes none
    double density_error = 0.0;       ///< 3 a u_lu
    std::vector<std::string> doubts;  ///< limits that do not hold; empty if it is stable
    StableUnits proposal;
};

/// The limits, for a sheet whose D dx is that of this lattice at any spacing:
///
///     tau = 3 nu dt / dx^2 + 1/2 > 0.51      the plain BGK collision; LBPM's MRT 0.508
///     3 a u_lu < 3 %                          change of the density across the device, with the
///     mean
///                                             of a, weighted with itself
///     a < 1 / (3 nu_lu)                       OpenLB: its porosity d stays positive
///     a + 2 b u_lu < 0.9                      HemoFlow: its force is explicit
///
/// with a = nu D dt, b = F dx / 2. HemoFlow has a mean inlet velocity of 0.05 of its own, half the
/// peak, and a viscosity of 3.22e-6 m^2/s; what changes its time step is `peak_velocity`. Targets
/// that do not take the resistance have the first limit only. Measured in HemoFlow: w lin_lu of 0.9
/// runs, 1.2 does not; in OpenLB any a below the limit; in LBPM tau of 0.508 runs, 0.502 does not.
///
/// The proposal raises u_lu up to 0.1 before it refines the spacing, as finer nodes cost more.
TargetStability stability_of(LatticeTarget target, const LatticeNodes& nodes, const Fluid& fluid,
                             const LatticeFlowOptions& flow);

/// One sentence for each limit that does not hold, with the targets that share it and what to
/// change.
std::vector<std::string> stability_notes(const std::vector<TargetStability>& targets);

}  // namespace braidzone
