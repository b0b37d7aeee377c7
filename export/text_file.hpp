#pragma once

#include <filesystem>
#include <string_view>

namespace braidzone {

/// Writes a whole file, creating its folder.
/// @throws IoError if that fails
void write_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace braidzone
