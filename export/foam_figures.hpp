#pragma once

#include "export/foam_flow.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace braidzone {

/// Names of the zones of a sac, and of the functions over them.
struct SacNames {
    std::string cells, neck, wall;             ///< zones
    std::string speed, neck_flow, wall_shear;  ///< functions
};

/// Of the largest sac (number 0) "sac", "sac_neck", "sac_wall", "sacSpeed", "neckFlow" and
/// "sacWallShear"; of the next "sac_2", "sac_2_neck", "sac_2_wall", "sac_2Speed", "sac_2NeckFlow",
/// "sac_2WallShear", and so on.
SacNames sac_names(std::size_t number);

/// A sac, and which of its face zones hold faces.
struct SacFigures {
    SacNames names;
    bool has_neck = true;
    bool has_wall = true;
};

/// Text of system/fdFunctions: OpenFOAM's own function objects for the flow in each sac, at every
/// iteration or time step.
///
/// - speed: mean speed over the sac's cells [m/s]
/// - neck flow: sum of the flow rates' magnitudes over its neck [m^3/s]. What enters leaves again,
///   so the inflow is half of it.
/// - wall shear: mean magnitude of the kinematic wall shear stress over its wall [m^2/s^2]
///
/// OpenFOAM refuses a function over a zone without faces; that one is left out.
/// @return empty without a sac
std::string figure_functions(const std::vector<SacFigures>& sacs);

/// The shell script `flow_figures` of a case, which turns the function objects' files into a table
/// and into flow_figures.csv: of each sac the inflow through its neck, mean speed and wall shear
/// stress, and, of a vessel with several outlets, the flow out of each; at the last iteration of
/// steady flow, or the mean over the last cycle of pulsatile flow.
/// @param density  [kg/m^3], for the wall shear stress
std::string flow_figures_script(const FoamFlow& flow, double density);

}  // namespace braidzone
