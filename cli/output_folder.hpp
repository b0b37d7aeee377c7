#pragma once

#include "cli/interruption.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace braidzone {

/// A folder of results that is whole or absent: it is written as a hidden sibling, which takes the
/// folder's place by one renaming. Until then an earlier run's folder stays as it is; if anything
/// fails, or a signal ends the program, the sibling is removed.
class OutputFolder {
public:
    /// @param wanted  where the results shall be; its parents are created
    /// @param force   replace a folder that no run wrote
    /// @param record  the file that tells which program wrote a folder
    /// @throws IoError if something is there that no earlier run wrote (a run's folder holds its
    ///         record) and `force` is not set, or the folder cannot be created
    OutputFolder(const std::filesystem::path& wanted, bool force,
                 const std::string& record = "summary.json");

    /// The folder to write into.
    const std::filesystem::path& path() const { return unfinished_->path(); }
    /// Where it will be.
    const std::filesystem::path& final_path() const { return wanted_; }

    /// Puts the folder in its place.
    /// @throws IoError if it cannot be renamed
    void commit();

private:
    std::filesystem::path wanted_;
    std::optional<UnfinishedOutput> unfinished_;
};

}  // namespace braidzone
