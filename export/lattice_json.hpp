#pragma once

#include "export/lattice_export.hpp"
#include "export/lattice_files.hpp"
#include "export/lattice_stability.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// What a target's folder holds, and what becomes of the lattice in it.
struct WrittenTarget {
    TargetStability stability;
    std::vector<LatticeFile> files;
};

/// All that lattice.json tells.
struct LatticeDescription {
    const LatticeNodes& nodes;
    const Vessel& vessel;
    const Fluid& fluid;
    const LatticeExportOptions& options;
    const LatticeUnits& units;
    const LatticeSeal& seal;
    const std::vector<WrittenTarget>& targets;
    const std::vector<std::string>& notes;
};

/// Writes lattice.json beside the targets' folders, whose files must be there: it has their hashes.
/// @throws IoError if a file cannot be read or written
void write_lattice_json(const std::filesystem::path& folder, const LatticeDescription& lattice);

}  // namespace braidzone
