#pragma once

#include "core/fluid.hpp"
#include "core/vessel.hpp"
#include "porous/resistance_sheet.hpp"

#include <filesystem>
#include <string>

namespace braidzone {

struct FoamCaseOptions {
    double inlet_velocity = 0.25;        ///< mean over the inlet [m/s]
    double coarse_cell = 0.45e-3;        ///< edge of the background cells [m]
    int surface_refinement = 1;          ///< halvings of the background cell at the wall
    int device_refinement = 2;           ///< halvings around the device
    int inlet = 0;                       ///< index of the vessel's opening that is the inlet
    std::string program;                 ///< command that runs Braidzone, for Allrun
    std::string case_file;               ///< case file that `export --onto` reads, for Allrun
};

/// Writes a complete OpenFOAM case: vessel surface with named solids (wall, inlet, outlet_1, ...),
/// the device's surface for refinement, dictionaries for blockMesh, surfaceFeatureExtract and
/// snappyHexMesh, boundary and initial fields, steady laminar flow (simpleFoam, SIMPLEC), `Allrun`,
/// `Allclean` and a README. `Allrun` meshes, applies the resistance by
/// `braidzone export CASE.toml --onto .` and solves.
/// @throws IoError if a file cannot be written
void write_foam_case(const std::filesystem::path& folder, const Vessel& vessel,
                     const ResistanceSheet& sheet, const Fluid& fluid,
                     const FoamCaseOptions& options);

}  // namespace braidzone
