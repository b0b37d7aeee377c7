#pragma once

#include "export/foam_flow.hpp"

#include <string>

namespace braidzone {

/// Which of the sac's face zones hold faces.
struct SacFaces {
    bool neck = true;
    bool wall = true;
};

/// Text of system/fdFunctions: OpenFOAM's own function objects for the flow in the sac, at every
/// iteration or time step.
///
/// - sacSpeed: mean speed over the cell zone "sac" [m/s]
/// - neckFlow: sum of the flow rates' magnitudes over the face zone "sac_neck" [m^3/s]. What enters
///   leaves again, so the inflow is half of it.
/// - sacWallShear: mean magnitude of the kinematic wall shear stress over the face zone "sac_wall"
///   [m^2/s^2]
///
/// OpenFOAM refuses a function over a zone without faces; that one is left out.
std::string figure_functions(const SacFaces& faces);

/// The shell script `flow_figures` of a case, which turns the function objects' files into a table
/// and into flow_figures.csv: at the last iteration of steady flow, or the mean over the last
/// cycle of pulsatile flow.
/// @param density  [kg/m^3], for the wall shear stress
std::string flow_figures_script(const FoamFlow& flow, double density);

}  // namespace braidzone
