#pragma once

#include "core/fluid.hpp"
#include "core/vessel.hpp"
#include "export/foam_flow.hpp"
#include "export/foam_form.hpp"
#include "porous/resistance_sheet.hpp"

#include <filesystem>
#include <string>

namespace braidzone {

struct FoamCaseOptions {
    FoamFlow flow = {};
    double coarse_cell = 0.45e-3;  ///< edge of the background cells [m]
    int surface_refinement = 1;    ///< halvings of the background cell at the wall
    /// Halvings around the free part of the device. The sheet is spread over six cells, and that
    /// thickness matters for the flow in the sac: in a sidewall phantom (mean speed 7.2 mm/s
    /// untreated) 2 halvings give 1.74 mm/s, 3 give 1.33, extrapolation to no thickness about 1.1.
    int device_refinement = 3;
    FoamForm form = FoamForm::zones;    ///< of the resistance
    int most_zones = 64;                ///< see `cluster`
    int inlet = 0;                      ///< index of the vessel's opening that is the inlet
    std::string program = "braidzone";  ///< command that runs Braidzone, for Allrun
    std::string case_file = "braidzone/case.toml";  ///< that Allrun applies; relative to the folder
};

/// Writes what says how a case with these openings is solved, whatever its mesh: controlDict,
/// fvSchemes, fvSolution, transportProperties, turbulenceProperties, 0/U, 0/p, `flow_figures`.
/// @throws InputError if a value of the flow is out of range; IoError if a file cannot be written
void write_foam_flow(const std::filesystem::path& folder, const std::vector<FoamOpening>& openings,
                     const FoamFlow& flow, const Fluid& fluid, FoamForm form = FoamForm::zones);

/// Writes a complete OpenFOAM case: vessel surface with named solids (wall, inlet, outlet_1, ...),
/// the device's surface for refinement, dictionaries for blockMesh, surfaceFeatureExtract and
/// snappyHexMesh, boundary and initial fields, the solver's dictionaries, `Allrun`, `flow_figures`,
/// `Allclean` and a README. `Allrun` meshes, applies the resistance by
/// `braidzone export CASE.toml --onto .`, solves and prints the figures.
/// @throws InputError if an option is out of range, or the outlets' conditions do not fit the
///         vessel's openings; IoError if a file cannot be written
void write_foam_case(const std::filesystem::path& folder, const Vessel& vessel,
                     const ResistanceSheet& sheet, const Fluid& fluid,
                     const FoamCaseOptions& options);

}  // namespace braidzone
