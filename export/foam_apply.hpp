#pragma once

#include "export/foam_form.hpp"
#include "export/foam_resistance.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

struct FoamApplyOptions {
    FoamDepositOptions deposit = {};
    FoamForm form = FoamForm::zones;
    int most_zones = 64;  ///< see `cluster`
    /// The case's fluid is shear-thinning: the resistance keeps the sheet's viscosity.
    bool shear_thinning = false;
};

/// What `apply_to_foam_case` found and wrote.
struct FoamApplication {
    int num_cells = 0;                         ///< of the mesh
    int num_resistant_cells = 0;               ///< with resistance
    int num_zones = 0;                         ///< FD_0000, ...
    double integral_sheet = 0.0;               ///< Darcy integral over the sheet [m]
    double integral_mesh = 0.0;                ///< the same, of what was written [m]
    std::vector<double> sac_volumes;           ///< of cell zones "sac", "sac_2", ... [m^3]
    std::vector<std::filesystem::path> files;  ///< written, relative to the case
    std::vector<std::string> warnings;
};

/// Applies the device to an existing OpenFOAM mesh: `braidzone export CASE.toml --onto FOAM_CASE`.
///
/// Reads constant/polyMesh, deposits the sheet, and writes
/// - constant/polyMesh/cellZones: the zones of the form (FD_*, FD) and the sacs that the device
///   closes off (`find_sacs`, `sac_names`); zones of the mesh are kept, those of an earlier call
///   replaced
/// - constant/polyMesh/faceZones, alike: each sac's neck and wall, and with `baffles` FD_*
/// - constant/fdPorosity: the resistance, included by constant/fvOptions and constant/fvModels
/// - system/fdFunctions: function objects that the form needs, and those for the flow in the sacs;
///   to be included in controlDict (`functions { #includeIfPresent "fdFunctions" }`)
/// - 0/fdDarcy, fdForchheimer, fdNormal, fdVoidFraction, fdSurfaceDensity, fdZone: for inspection;
///   no solver reads them
/// - with `per_cell`: 0/fdNuD_*, which the solver reads
/// - fd_export.json: form, units, zones, integrals, checks
///
/// All of them or none: see `FoamUpdate`.
///
/// The fluid's density does not enter: D and F are properties of the sheet. The viscosity that the
/// solver multiplies D with must be the sheet's; a warning says so if constant/transportProperties
/// holds another one. With `shear_thinning` it is written into the sources.
///
/// @throws GeometryError if the mesh is more than 300 times as large as the device (millimetres
/// taken
///         for metres); else what `read_foam_mesh`, `deposit` and `write_cell_zones` throw
FoamApplication apply_to_foam_case(const std::filesystem::path& foam_case,
                                   const ResistanceSheet& sheet,
                                   const FoamApplyOptions& options = {});

}  // namespace braidzone
