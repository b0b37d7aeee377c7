#pragma once

#include "core/centerline.hpp"
#include "core/toml_reader.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string_view>

namespace braidzone {

/// A measured value with its standard deviation.
struct MeasuredValue {
    double value = 0.0;  ///< [m], of a force [N]
    double sd = 0.0;     ///< in the same unit; > 0
};

/// Radial force with which a stretch of the device presses on the wall.
struct MeasuredContactForce {
    MeasuredValue force;  ///< [N]; > 0
    /// The stretch, arc lengths on the centerline [m]; infinite: to the device's end.
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
};

/// What else is known of the implanted device: two or three numbers that tell more about its
/// length than its surface does, in the order of `scalar_names`, and its force on the wall.
struct MeasuredScalars {
    std::array<std::optional<MeasuredValue>, 3> values;
    std::optional<MeasuredContactForce> contact_force = {};
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
///     contact_force = "0.12 N"      # radial, on the wall
///     contact_force_sd = "0.02 N"
///     contact_force_from = "18 mm"  # the stretch that bears it; without it the whole device
///     contact_force_to = "24 mm"
///
/// All are optional.
/// @throws ConfigError with file, line and key for a value without its standard deviation or the
///         other way round, a standard deviation or a force that is not positive, a stretch without
///         its force, one of its ends or a length, or an unknown key
MeasuredScalars read_measured_scalars(const TomlTable& table, const Centerline& centerline);

}  // namespace braidzone
