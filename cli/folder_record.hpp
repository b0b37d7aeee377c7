#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// The file in which a folder of results says what the program wrote into it, with SHA-256 hashes,
/// in the form that `sha256sum --check` reads.
constexpr const char* folder_record_name = ".files.sha256";

/// Records all files of a folder.
/// @throws IoError if one cannot be read, or the record cannot be written
void write_folder_record(const std::filesystem::path& folder);

/// True if a folder's record names the file.
bool is_recorded(const std::filesystem::path& folder, const std::string& file);

/// A file as it was found, by what a change of it changes.
struct FoundFile {
    std::filesystem::path file;  ///< relative to the folder
    std::uintmax_t size = 0;
    std::filesystem::file_time_type changed;
};

/// What became of a folder since its record was written.
struct FolderContents {
    /// As they were written: name and hash are recorded.
    std::vector<FoundFile> unchanged;
    /// Files that are not as they were written, and files and folders that others put among them.
    std::vector<std::filesystem::path> altered;
    /// Files and folders at the top that nothing was recorded of: the user's own.
    std::vector<std::filesystem::path> own;
};

/// Compares a folder with its record; without one every file in it counts as altered. Links are
/// never followed, and what is not there any more is left out.
/// @throws IoError if a file cannot be read
FolderContents compare_with_record(const std::filesystem::path& folder);

/// Removes those of the files that are still as they were found, and the folders that this leaves
/// empty, `folder` too.
/// @return true if nothing is left
bool remove_found(const std::filesystem::path& folder, const std::vector<FoundFile>& files);

}  // namespace braidzone
