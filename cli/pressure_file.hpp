#pragma once

#include "porous/pressure_bench.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// A bench for pressure drops as its file states it, in SI units.
struct PressureFile {
    PressureBench bench;
    std::vector<std::string> device_notes;  ///< values that are extrapolated or uncertain
};

/// Reads a bench: [device], [fluid] and [porous] (the law) as in a case file, and [bench] with
/// `diameter` (of the device on the bench, default nominal) or in its place `metal_coverage`,
/// `channel_diameter` (default: the device's), `density_increase`, `gap`, `second_layer`,
/// `added_inertia` (`PressureBench`).
///
/// @param overrides  "section.key=value", which win over the file
/// @throws IoError if the file cannot be read; ConfigError, with file, line and key, for anything
///         in it that is unknown, missing, of the wrong type or unit, or out of range
PressureFile read_pressure_file(const std::filesystem::path& file,
                                const std::vector<std::string>& overrides = {});

/// The keys whose values differ between two models of the same file, "bench.second_layer=1.05":
/// overrides that make one file out of the other.
std::vector<std::string> changed_pressure_keys(const PressureBench& before,
                                               const PressureBench& after);

}  // namespace braidzone
