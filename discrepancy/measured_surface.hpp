#pragma once

#include "core/length_unit.hpp"
#include "core/vector.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace braidzone {

/// Reads points of a device's surface as it was measured.
///
/// - STL, VTP, VTK, PLY, OBJ: the points of a triangulated surface.
/// - CSV: a header `x_mm,y_mm,z_mm` (or m, cm, um), three numbers a line.
/// - XYZ: three numbers a line with blanks between, no header; lines that begin with # are skipped.
///
/// @param unit  of the coordinates; needed for all but CSV, whose header states it
/// @return [m]
/// @throws ConfigError if the unit is missing, or stands beside a CSV header of another one;
/// IoError
///         if the file cannot be read; InputError for another ending, a header or line that is none
///         of these, or a coordinate that is not finite, with its line
std::vector<Vec3> read_measured_surface(const std::filesystem::path& path,
                                        const std::optional<LengthUnit>& unit);

}  // namespace braidzone
