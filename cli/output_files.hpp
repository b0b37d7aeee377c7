#pragma once

#include "cli/case_hash.hpp"
#include "core/working_folder.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {

/// Files that are whole or absent: each is written in a hidden folder beside it and renamed at the
/// end; if anything fails, or a signal ends the program, the folder is removed.
class OutputFiles {
public:
    /// @param inputs  files that are not replaced, whether `force` is set or not
    /// @param force   replace files that are there
    OutputFiles(std::vector<InputFile> inputs, bool force)
        : inputs_(std::move(inputs)), force_(force)
    {
    }

    /// A path to write the file to; it has the same name.
    /// @throws ConfigError if it is one of the inputs; IoError if the file is there and `force` is
    ///         not set, if it is a folder, or its folder cannot be created
    std::filesystem::path add(const std::filesystem::path& wanted);

    /// Puts all files in their places.
    /// @throws IoError if one cannot be renamed
    void commit();

private:
    std::vector<InputFile> inputs_;
    bool force_ = false;
    std::vector<std::pair<std::unique_ptr<WorkingFolder>, std::filesystem::path>> files_;
};

/// The one text file that a verb writes, whole or absent. Made before the verb's work, so that a
/// path that cannot be written to is refused before and not after it.
class TextOutput {
public:
    /// @param wanted  its path
    /// @param inputs  files that are not replaced, whether `force` is set or not
    /// @param force   replace a file that is there
    /// @throws ConfigError, IoError as `OutputFiles::add`
    TextOutput(const std::filesystem::path& wanted, std::vector<InputFile> inputs, bool force)
        : wanted_(wanted), files_(std::move(inputs), force), unfinished_(files_.add(wanted))
    {
    }

    const std::filesystem::path& path() const { return wanted_; }

    /// @throws IoError if the file cannot be written
    void write(const std::string& text);

private:
    std::filesystem::path wanted_;
    OutputFiles files_;
    std::filesystem::path unfinished_;
};

}  // namespace braidzone
