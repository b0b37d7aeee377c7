#pragma once

#include "export/lattice_seal.hpp"
#include "export/lattice_targets.hpp"
#include "export/lattice_units.hpp"
#include "export/vessel_extension.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

struct LatticeExportOptions {
    std::vector<LatticeTarget> targets = default_lattice_targets();
    LatticeFlowOptions flow;
    OpeningFaces openings = OpeningFaces::as_is;
    int inlet = 0;                 ///< index of the vessel's opening that is the inlet
    std::vector<NeckProbe> necks;  ///< where the device's nodes are to part the lumen
};

/// The clearance of extended openings: three nodes, so that walls stay apart on the lattice [m].
double extension_clearance(double spacing);

/// Writes the lattice: lattice.json with its grid, openings, units, conventions, integrals, limits
/// and files, and for each target a folder with what that program reads and a README.
/// @return sentences about what a target cannot express (a tangential resistance other than the
///         normal one, a quadratic part, any resistance at all), about limits that the units exceed
///         and about necks that leak; they are in lattice.json, too
/// @throws IoError if a file cannot be written; ConfigError if a target cannot take the lattice
std::vector<std::string> write_lattice(const std::filesystem::path& folder,
                                       const LatticeNodes& nodes, const Vessel& vessel,
                                       const Fluid& fluid, const LatticeExportOptions& options);

/// Continues the vessel's openings if that is asked for, lays it on the field's lattice and writes
/// that. The field is the same whatever becomes of the openings.
/// @return the sentences of `write_lattice`, and one for each opening that is continued
/// @throws ConfigError if the lattice is too large for the machine, IoError if it is for the disk,
///         both before anything is made; and as `extend_openings`, `make_lattice_nodes`
///         and `write_lattice`
std::vector<std::string> export_lattice(const std::filesystem::path& folder,
                                        const PorousField& field, const Vessel& vessel,
                                        const Fluid& fluid, const LatticeExportOptions& options);

}  // namespace braidzone
