#pragma once

#include "porous/law_comparison.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// The laws side by side, in lines for the terminal: a and b of the free part, pressure drops at
/// four velocities, a over the recommended law's, and which rhombi lie outside a law's range.
std::string law_table(const std::vector<LawComparison>& laws);

/// The same figures as a CSV file, one law a line.
/// @throws IoError if the file cannot be written
void write_law_table(const std::filesystem::path& path, const std::vector<LawComparison>& laws);

}  // namespace braidzone
