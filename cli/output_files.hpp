#pragma once

#include "cli/interruption.hpp"

#include <filesystem>
#include <memory>
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

}  // namespace braidzone
