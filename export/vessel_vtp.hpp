#pragma once

#include "core/vessel.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `vessel.vtp`: the closed surface of the lumen in the vessel's length unit, normals
/// outwards. Cell field `opening`: -1 on the wall, the opening's number on its cap.
/// @throws IoError if the file cannot be written
void write_vessel_vtp(const std::filesystem::path& path, const Vessel& vessel);

}  // namespace braidzone
