#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace braidzone {

/// SHA-256 of a file's content (FIPS 180-4), as 64 hexadecimal digits.
/// @throws IoError if the file cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

/// SHA-256 of a text.
std::string sha256_of_text(std::string_view text);

}  // namespace braidzone
