#pragma once

#include "cli/case_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// A file that a case reads.
struct InputFile {
    std::string role;  ///< "case", "vessel", "centerline", ...
    std::filesystem::path path;
};

/// The files that a case reads, the case file first.
std::vector<InputFile> input_files(const Case& job);

/// SHA-256 over the resolved case, files by their names without folders, and the content of the
/// files it reads: equal for equal input, wherever it lies and however it was given (in the file or
/// by --set).
/// @throws IoError if a file cannot be read
std::string case_hash(const Case& job);

}  // namespace braidzone
