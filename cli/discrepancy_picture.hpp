#pragma once

#include "discrepancy/diagnosis.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `discrepancy.png`: the gap of each patch over (angle, arc length) before and after the
/// effect, and what remains unexplained, side by side with one colour scale: red where the measured
/// device lies outside the simulated one, blue inside. Frames mark patches of significant clusters.
/// @throws IoError if the file cannot be written
void write_discrepancy_picture(const std::filesystem::path& path, const Diagnosis& diagnosis);

}  // namespace braidzone
