#pragma once

#include "cli/curve_labels.hpp"
#include "discrepancy/curve_diagnosis.hpp"

#include <filesystem>

namespace braidzone {

/// Draws a diagnosed curve, as PNG: on the left the measured points with the simulated curve before
/// and after the effect, on the right the relative gaps of both with the noise floor of two
/// standard deviations.
/// @throws IoError if the file cannot be written
void write_curve_picture(const std::filesystem::path& path, const CurveDiagnosis& diagnosis,
                         const CurveLabels& labels);

}  // namespace braidzone
