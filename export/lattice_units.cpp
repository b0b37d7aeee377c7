#include "export/lattice_units.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace braidzone {

LatticeUnits propose_units(const LatticeNodes& nodes, const Fluid& fluid,
                           const LatticeFlowOptions& options)
{
    if (!(options.peak_velocity > 0.0)) {
        throw ConfigError(fmt::format("peak velocity {:.6g} m/s of a lattice: must be positive",
                                      options.peak_velocity));
    }
    if (!(options.velocity_lu > 0.0 && options.velocity_lu <= highest_velocity_lu)) {
        throw ConfigError(fmt::format(
            "velocity {:.6g} of a lattice, in lattice units: must be positive, {:.6g} at most",
            options.velocity_lu, highest_velocity_lu));
    }
    const double kinematic_viscosity = fluid.viscosity / fluid.density;
    LatticeUnits units;
    units.spacing = nodes.grid.spacing;
    units.time_step = options.velocity_lu * units.spacing / options.peak_velocity;
    units.viscosity_lu = kinematic_viscosity * units.time_step / (units.spacing * units.spacing);
    units.relaxation_time_lu = 3.0 * units.viscosity_lu + 0.5;
    units.mach = std::numbers::sqrt3 * options.velocity_lu;
    for (std::size_t i = 0; i < nodes.resisting.size(); ++i) {
        units.largest_drag_lu =
            std::max(units.largest_drag_lu, kinematic_viscosity * nodes.darcy[i] * units.time_step);
        units.largest_inertia_lu =
            std::max(units.largest_inertia_lu, 0.5 * nodes.forchheimer[i] * units.spacing);
    }
    return units;
}

}  // namespace braidzone
