#pragma once

#include "core/repeat_curve.hpp"

#include <filesystem>

namespace braidzone {

/// Reads a measured pressure drop: a CSV file whose header names the columns with their units,
/// `velocity_m_s` (or `_mm_s`, `_cm_s`) first, then one column a repeat, each beginning with
/// `pressure_drop` and ending in `_Pa` (or `_mmHg`, `_mbar`), such as
/// `velocity_m_s,pressure_drop_1_Pa,pressure_drop_2_Pa`. Velocities are means over the channel
/// [m/s] and increase from 0 or above.
/// @return abscissae: velocities [m/s]; means: pressure drops [Pa]
/// @throws what `read_repeat_curve` throws
RepeatCurve read_pressure_curve(const std::filesystem::path& path);

}  // namespace braidzone
