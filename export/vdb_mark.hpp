#pragma once

#include <filesystem>

namespace braidzone {

/// OpenVDB marks each file with a random UUID (after 8 bytes of magic number, 4 of file version, 8
/// of library version and 1 that says whether there are offsets). It is replaced by one made from
/// the content, so that equal fields give equal files.
/// @throws IoError if the file cannot be rewritten
void replace_vdb_mark(const std::filesystem::path& path);

}  // namespace braidzone
