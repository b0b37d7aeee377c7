#pragma once

#include "export/lattice_units.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// What a lattice is written for.
enum class LatticeTarget { numpy, openlb, palabos, walberla, hemoflow };

/// Its name in the case file, and its folder.
std::string target_name(LatticeTarget target);

std::vector<LatticeTarget> all_lattice_targets();

/// Those that take any vessel: all but HemoFlow, which wants its openings on the faces of the box.
std::vector<LatticeTarget> default_lattice_targets();

struct LatticeExportOptions {
    std::vector<LatticeTarget> targets = default_lattice_targets();
    LatticeFlowOptions flow;
    int inlet = 0;  ///< index of the vessel's opening that is the inlet
};

/// Writes the lattice: lattice.json with its grid, openings, units, conventions, integrals and
/// files, and for each target a folder with what that program reads and a README.
/// @return sentences about what a target cannot express (a tangential resistance other than the
///         normal one, a quadratic part, any resistance at all) and about doubtful units; they are
///         in lattice.json, too
/// @throws IoError if a file cannot be written; ConfigError if a target cannot take the lattice
std::vector<std::string> write_lattice(const std::filesystem::path& folder,
                                       const LatticeNodes& nodes, const Vessel& vessel,
                                       const Fluid& fluid, const LatticeExportOptions& options);

}  // namespace braidzone
