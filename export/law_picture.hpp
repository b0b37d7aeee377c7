#pragma once

#include "porous/law_comparison.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Draws what the laws make of a deployed braid, as PNG: on the left the pressure drop over the
/// velocity against the velocity, for the mean of the free part (the line meets the axis at a and
/// rises with b); on the right a against the metal coverage, over the device's rhombi.
/// @throws IoError if the file cannot be written
void write_law_picture(const std::filesystem::path& path, const ResistanceSheet& sheet,
                       const std::vector<LawComparison>& laws);

}  // namespace braidzone
