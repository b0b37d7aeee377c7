#pragma once

#include "core/interruption.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace braidzone {

/// A hidden folder beside an output, in which the output is made: on the same file system, so that
/// it gets to its place by renaming. It is removed with this object, or by a signal.
///
/// Its name is short whatever the output's: ".braidzone.<hash of the output's name>.<process>-<n>
/// .unfinished". While its process lives it holds a lock (flock) on the file `owner` in it, which
/// no reuse of a process number can imitate and the system gives back however the process ends.
class WorkingFolder {
public:
    /// Makes the folder, and before it removes those that ended processes left of the same output.
    /// @param parent  where; an existing folder
    /// @param output  the name of what is made in it
    /// @throws IoError if it cannot be made
    WorkingFolder(const std::filesystem::path& parent, const std::string& output);
    ~WorkingFolder();
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

    const std::filesystem::path& path() const { return unfinished_->path(); }

    /// Moves what was made to its place by `move`, which no signal interrupts, and removes the
    /// folder.
    template <typename Move>
    void finish(const Move& move)
    {
        unfinished_->finish([&] {
            move();
            remove();
        });
    }

    /// Leaves the folder where it is, for the next process to find. To be called in `finish` only.
    void leave() { unfinished_->forget(); }

private:
    bool try_to_make(const std::filesystem::path& folder, const std::string& output);
    void remove() const;
    std::optional<UnfinishedOutput> unfinished_;
    int owner_ = -1;  ///< descriptor of the locked file
};

/// Removes the working folders of an output whose processes have ended.
///
/// Only those of this machine (the same host name, or the same start of its kernel) are judged: on
/// a file system that several machines share, a lock may be known to the one that holds it alone.
/// @param before  called with each folder before it is removed
/// @return true if there is one whose process lives
bool clear_working_folders(const std::filesystem::path& parent, const std::string& output,
                           const std::function<void(const std::filesystem::path&)>& before = {});

}  // namespace braidzone
