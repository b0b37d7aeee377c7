#pragma once

#include "deploy/release_schedule.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Reads a table of ring spacings: a CSV file with the header `s_mm,lambda` (or `s_m`, `s_cm`,
/// `s_um`), then one point a line, two numbers with a comma between. Arc lengths may increase or
/// decrease; they are returned increasing. Empty lines at the end are allowed.
/// @throws IoError if the file cannot be read; InputError with the number of the line if it is not
///         such a table: another header, a line without two numbers, arc lengths that turn back,
///         fewer than two points, a spacing that `validate` refuses
std::vector<SpacingPoint> read_spacing_table(const std::filesystem::path& path);

}  // namespace braidzone
