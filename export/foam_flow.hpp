#pragma once

#include "core/carreau_yasuda.hpp"
#include "export/flow_waveform.hpp"
#include "export/foam_outlets.hpp"

#include <optional>

namespace braidzone {

/// The flow that an OpenFOAM case solves: laminar, in a rigid vessel.
struct FoamFlow {
    double inlet_velocity = 0.25;               ///< mean over the inlet, without a waveform [m/s]
    std::optional<FlowWaveform> waveform = {};  ///< pulsatile flow; steady if absent
    int cycles = 3;            ///< periods of the waveform; figures are of the last
    double max_courant = 2.0;  ///< of pulsatile flow, decides the time step [-]
    FoamOutlets outlets = {};
    std::optional<CarreauYasuda> rheology = {};  ///< shear-thinning; Newtonian if absent
};

/// Flow rate into the inlet, steady or the mean over the period [m^3/s].
inline double mean_inflow(const FoamFlow& flow, double inlet_area)
{
    return flow.waveform ? mean_flow_rate(*flow.waveform) : flow.inlet_velocity * inlet_area;
}

}  // namespace braidzone
