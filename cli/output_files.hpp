#pragma once

#include "cli/interruption.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {

/// Files that are whole or absent: each is written as a hidden sibling and renamed at the end; if
/// anything fails, or a signal ends the program, the siblings are removed.
class OutputFiles {
public:
    /// @param force  replace files that are there
    explicit OutputFiles(bool force) : force_(force) {}

    /// A path to write the file to; it has the same ending.
    /// @throws IoError if the file is there and `force` is not set, or its folder cannot be created
    std::filesystem::path add(const std::filesystem::path& wanted);

    /// Puts all files in their places.
    /// @throws IoError if one cannot be renamed
    void commit();

private:
    bool force_ = false;
    std::vector<std::pair<std::unique_ptr<UnfinishedOutput>, std::filesystem::path>> files_;
};

/// The one text file that a verb writes, whole or absent. Made before the verb's work, so that a
/// path that cannot be written to is refused before and not after it.
class TextOutput {
public:
    /// @param wanted  its path
    /// @param force   replace a file that is there
    /// @throws IoError as `OutputFiles::add`
    TextOutput(const std::filesystem::path& wanted, bool force)
        : wanted_(wanted), files_(force), unfinished_(files_.add(wanted))
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
