#pragma once

#include "export/foam_zones.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// Writes fields to look at in ParaView, which no solver reads: fdDarcy [1/m^2] and fdForchheimer
/// [1/m] as deposited, before zones are formed; fdNormal; fdVoidFraction and
/// fdSurfaceDensity [1/m] of the whole device; fdZone (number of the zone, -1 outside).
///
/// They go into the case's start fields: the folder 0, or 0.orig if only that exists.
/// @return the files, relative to the case
/// @throws IoError if one cannot be written
std::vector<std::filesystem::path> write_inspection_fields(const std::filesystem::path& foam_case,
                                                           const FoamMesh& mesh,
                                                           const CellResistance& resistance,
                                                           const std::vector<FoamZone>& zones);

}  // namespace braidzone
