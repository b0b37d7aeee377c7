#pragma once

#include "discrepancy/curve_noise.hpp"

#include <filesystem>
#include <string>

namespace braidzone {

/// In which units the file of a curve's noise is written, besides shares [-].
struct CurveNoiseUnits {
    std::string curve;                            ///< "force curve"; the file says of which it is
    std::string ordinate_unit, abscissa_unit;     ///< "mN", "mm"
    double ordinate_si = 1.0, abscissa_si = 1.0;  ///< of one of them
};

/// The noise as JSON: "curve", "point_sd", "absolute_sd_mN", "scale_sd", "zero_sd_mN",
/// "background_sd", "background_length" (over the range of the abscissae), "abscissa_sd_mm",
/// "source".
std::string curve_noise_text(const CurveNoise& noise, const CurveNoiseUnits& units);

/// Reads such a file; every value must be there.
/// @throws IoError if it cannot be read; InputError with the key for a missing, unknown or negative
///         value, for a file of another curve, or text that is no JSON
CurveNoise read_curve_noise(const std::filesystem::path& path, const CurveNoiseUnits& units);

}  // namespace braidzone
