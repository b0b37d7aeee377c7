#pragma once

#include "core/length_unit.hpp"
#include "discrepancy/diagnosis.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `discrepancy.vtp`: the simulated device of the case as it is, points the wire crossings,
/// cells the rhombi, in the vessel's length unit. Point fields, each the value of the patch that
/// the crossing lies in and NaN where nothing was measured: `gap_before`, `gap_after` (if there is
/// an effect), `unexplained` [m], `t_before` (standardised).
/// @throws IoError if the file cannot be written
void write_discrepancy_vtp(const std::filesystem::path& path, const Diagnosis& diagnosis,
                           const LengthUnit& unit);

}  // namespace braidzone
