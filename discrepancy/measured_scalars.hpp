#pragma once

#include "core/centerline.hpp"
#include "core/toml_reader.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace braidzone {

/// A measured value with its standard deviation.
struct MeasuredValue {
    double value = 0.0;  ///< [m]
    double sd = 0.0;     ///< [m]; > 0
};

/// What else is known of the implanted device: two or three numbers that tell more about its
/// length than its surface does. Order of the values: that of `scalar_names`.
struct MeasuredScalars {
    std::array<std::optional<MeasuredValue>, 3> values;
};

/// Arc lengths of the ends on the centerline, and the length between them.
constexpr std::array<std::string_view, 3> scalar_names = {"distal_end", "proximal_end",
                                                          "implanted_length"};

/// Reads them from a TOML file, each with a standard deviation:
///
///     distal_end = "24.8 mm"        # arc length on the centerline, or a point ["x mm", ...]
///     distal_end_sd = "0.3 mm"
///     proximal_end = "8.1 mm"
///     proximal_end_sd = "0.3 mm"
///     implanted_length = "16.7 mm"
///     implanted_length_sd = "0.5 mm"
///
/// All are optional.
/// @throws ConfigError with file, line and key for a value without its standard deviation or the
///         other way round, a standard deviation that is not positive, or an unknown key
MeasuredScalars read_measured_scalars(const TomlTable& table, const Centerline& centerline);

}  // namespace braidzone
