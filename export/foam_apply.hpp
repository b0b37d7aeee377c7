#pragma once

#include "export/foam_resistance.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

struct FoamApplyOptions {
    FoamDepositOptions deposit = {};
    int most_zones = 64;  ///< see `cluster`
    /// The case's fluid is shear-thinning: the resistance keeps the sheet's viscosity.
    bool shear_thinning = false;
};

/// What `apply_to_foam_case` found and wrote.
struct FoamApplication {
    int num_cells = 0;                         ///< of the mesh
    int num_resistant_cells = 0;               ///< with resistance
    int num_zones = 0;                         ///< porous zones FD_0000, ...
    double integral_sheet = 0.0;               ///< Darcy integral over the sheet [m]
    double integral_zones = 0.0;               ///< sum over zones of D times volume [m]
    std::optional<double> sac_volume;          ///< of cell zone "sac" [m^3]; see `find_sac`
    std::vector<std::filesystem::path> files;  ///< written, relative to the case
    std::vector<std::string> warnings;
};

/// Applies the device to an existing OpenFOAM mesh: `braidzone export CASE.toml --onto FOAM_CASE`.
///
/// Reads constant/polyMesh, deposits the sheet, and writes
/// - constant/polyMesh/cellZones: zones FD_* and, where the device closes off a sac, "sac"
/// - constant/fvOptions and its copy constant/fvModels: the resistance of the zones
/// - constant/polyMesh/faceZones: the sac's neck and wall, merged with those of the mesh
/// - system/fdFunctions: function objects for the flow in the sac, to be included in controlDict
///   (`functions { #includeIfPresent "fdFunctions" }`); absent without a sac
/// - 0/fdDarcy, fdForchheimer, fdNormal, fdVoidFraction, fdSurfaceDensity, fdZone: for inspection;
///   no solver reads them
/// - fd_export.json: units, zones, integrals, checks
///
/// The fluid's density does not enter: D and F are properties of the sheet. The viscosity that the
/// solver multiplies D with must be the sheet's (constant/transportProperties of the same case),
/// unless `shear_thinning`: then it is written into the sources, and the density with it.
///
/// @throws what `read_foam_mesh`, `deposit` and `write_foam_zones` throw
FoamApplication apply_to_foam_case(const std::filesystem::path& foam_case,
                                   const ResistanceSheet& sheet,
                                   const FoamApplyOptions& options = {});

}  // namespace braidzone
