#pragma once

#include "cli/case_file.hpp"
#include "discrepancy/lumen.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// Reads a case that `diagnose` can deploy again and again, with absolute paths of its files.
/// @throws ConfigError if it has a second device, or axial freedom, which takes minutes; else what
///         `read_case` throws
Case read_diagnosed_case(const std::filesystem::path& file,
                         const std::vector<std::string>& overrides);

/// The vessel of a case without the case's own wall offset, which the model holds.
Lumen lumen_of(const Case& job);

}  // namespace braidzone
