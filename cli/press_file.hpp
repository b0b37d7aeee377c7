#pragma once

#include "deploy/flow_diverter.hpp"
#include "deploy/press_test.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// A press test as its file states it, in SI units.
struct PressFile {
    FlowDiverter device;
    std::vector<std::string> device_notes;  ///< values that are extrapolated or uncertain
    PressOptions options;
};

/// Reads a press test: [device] as in a case file, and [press] with `notch_width`, `notch_angle`,
/// `edge_radius`, `head` ("cylinder" or "flat"), `head_radius`, `stroke`, `step`, `load_step`,
/// `nodes_per_ring`, `bending_ratio`, `residual_tolerance`, `friction`, `surface_factor`,
/// `radial_factor`, `zero_offset`, `stiffening`; all of [press] has defaults (`PressOptions`).
///
/// @param overrides  "section.key=value", which win over the file
/// @throws IoError if the file cannot be read; ConfigError, with file, line and key, for anything
///         in it that is unknown, missing, of the wrong type or unit, or out of range
PressFile read_press_file(const std::filesystem::path& file,
                          const std::vector<std::string>& overrides = {});

/// The keys whose values differ between two models of the same press file, "press.friction=0.2":
/// overrides that make one file out of the other.
std::vector<std::string> changed_press_keys(const FlowDiverter& device_before,
                                            const PressOptions& before,
                                            const FlowDiverter& device_after,
                                            const PressOptions& after);

}  // namespace braidzone
