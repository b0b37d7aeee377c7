#pragma once

#include "cli/case_hash.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Refuses an output folder that is there and is, or holds, an input file, the current folder or
/// the home folder: to replace it would delete them. Links are followed, on both sides.
/// @throws ConfigError which of them it is
void require_holds_no_input(const std::filesystem::path& folder,
                            const std::vector<InputFile>& inputs);

/// Refuses an output file that is an input file, under whatever name.
/// @throws ConfigError which of them it is
void require_no_input(const std::filesystem::path& file, const std::vector<InputFile>& inputs);

}  // namespace braidzone
