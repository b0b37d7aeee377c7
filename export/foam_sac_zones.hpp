#pragma once

#include "export/foam_mesh.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Writes the zones of the sac and what reports the flow in it:
/// - constant/polyMesh/cellZones: "sac"
/// - constant/polyMesh/faceZones: "sac_neck" and "sac_wall", see foam_neck.hpp
/// - system/fdFunctions: see `figure_functions`
///
/// Other zones are kept; those of an earlier call are replaced or, without a sac, removed.
/// @param sac  cell indices; empty if there is no sac
/// @return the files that hold something of the sac, relative to the case
/// @throws IoError or InputError if a file cannot be read or written
std::vector<std::filesystem::path> write_sac_zones(const std::filesystem::path& foam_case,
                                                   const FoamMesh& mesh,
                                                   const std::vector<int>& sac);

}  // namespace braidzone
