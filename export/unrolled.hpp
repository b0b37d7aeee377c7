#pragma once

#include "core/length_unit.hpp"
#include "deploy/deployment.hpp"
#include "porous/resistance_sheet.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `unrolled.vtp`: the cells of `device.vtp` with the same fields, on the unfolded surface
/// of the force-free device: x around (0 to pi D0), y along from the distal end (Zavodszky et al.
/// 2020, Figures 8 and 9), in the vessel's length unit. Cells across the cut keep their shape.
/// @throws IoError if the file cannot be written
void write_unrolled(const std::filesystem::path& path, const Deployment& deployment,
                    const ResistanceSheet& sheet, const LengthUnit& unit);

/// Writes `unrolled.png`: maps of wall contact, density increase, contact pressure and radial
/// expansion side by side on the unfolded surface, each with its colour scale, unit and title.
/// Drawn without a display.
/// @throws IoError if the file cannot be written
void write_unrolled_picture(const std::filesystem::path& path, const Deployment& deployment,
                            const ResistanceSheet& sheet);

}  // namespace braidzone
