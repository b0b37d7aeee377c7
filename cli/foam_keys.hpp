#pragma once

#include "core/toml_reader.hpp"
#include "export/foam_case.hpp"

namespace braidzone {

/// Reads the keys of an [[export]] with format = "openfoam", and the waveform that they name.
/// @throws ConfigError, with file, line and key, for anything of the wrong type or unit, out of
///         range or contradictory; what `read_flow_waveform` throws
FoamCaseOptions read_foam_options(const TomlTable& table);

}  // namespace braidzone
