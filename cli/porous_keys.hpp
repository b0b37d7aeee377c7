#pragma once

#include "core/fluid.hpp"
#include "core/toml_reader.hpp"
#include "porous/resistance_law.hpp"

namespace braidzone {

/// The fluid that a file's [fluid] section describes: `density`, `viscosity`; blood by default.
/// @throws ConfigError for a value that is not positive
Fluid read_fluid(const TomlTable& table);

/// The resistance law that a file's [porous] section names, with its constants; braid-stokes by
/// default.
/// @throws ConfigError for an unknown law or a value out of range; what `read_measured_law` throws
ResistanceLaw read_law(const TomlTable& table);

}  // namespace braidzone
