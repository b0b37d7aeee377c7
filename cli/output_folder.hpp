#pragma once

#include "cli/case_hash.hpp"
#include "cli/folder_record.hpp"
#include "core/working_folder.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// A folder of results that is whole or absent: it is written in a hidden sibling, and takes the
/// folder's place by one renaming. Until then an earlier run's folder stays as it is; if anything
/// fails, or a signal ends the program, the sibling is removed.
///
/// Of an earlier run's folder, only files are deleted that the run wrote and nobody changed since
/// (`folder_record.hpp`):
/// - files and folders that the user put beside them, at the top of the folder, stay there;
/// - if a file was changed, or others wrote among the run's files (a solver in openfoam/), the
///   earlier folder is moved aside as a whole, so that results and what they belong to stay
///   together: "DIR.kept-1", or the next free number;
/// - with `force` all of it is deleted.
class OutputFolder {
public:
    /// @param wanted  where the results shall be; its parents are created
    /// @param inputs  files that must not be lost with an earlier folder
    /// @param force   replace a folder whatever it holds
    /// @param record  the file that tells which program wrote a folder
    /// @throws ConfigError if the folder is, or holds, one of the inputs, the current or the home
    ///         folder, whether `force` is set or not; IoError if something is there that no earlier
    ///         run wrote (a run's folder holds its record) and `force` is not set, or the folder
    ///         cannot be created
    OutputFolder(const std::filesystem::path& wanted, const std::vector<InputFile>& inputs,
                 bool force, const std::string& record = "summary.json");

    /// The folder to write into.
    const std::filesystem::path& path() const { return content_; }
    /// Where it will be.
    const std::filesystem::path& final_path() const { return wanted_; }

    /// Puts the folder in its place.
    /// @return what was moved aside, and why, for the user; empty if nothing was
    /// @throws IoError if it cannot be renamed
    std::string commit();

private:
    std::string replace(const FolderContents& earlier);
    void exchange_with(const std::filesystem::path& place);

    std::filesystem::path wanted_, content_;
    std::vector<InputFile> inputs_;
    bool force_ = false;
    std::optional<WorkingFolder> working_;
};

/// Commits, and says on stderr what was moved aside.
void put_in_place(OutputFolder& folder);

}  // namespace braidzone
