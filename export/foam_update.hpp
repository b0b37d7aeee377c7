#pragma once

#include "core/working_folder.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace braidzone {

/// What becomes of a case, by paths relative to it.
struct FoamChanges {
    std::vector<std::filesystem::path> written;  ///< in `FoamUpdate::staging`, in this order
    std::vector<std::filesystem::path> removed;  ///< if they are there
    /// One of `written` without which no solver starts: it goes first and comes last.
    std::filesystem::path key;
};

/// Changes of the files of a case that take place together or not at all.
///
/// The new files are written into a hidden folder in the case. Then what they replace is linked
/// there too, a journal says what is about to happen, and the files are renamed into their places.
/// If anything fails the old state is put back, to the byte; a signal (INT, TERM, HUP) waits until
/// the renaming is done. What no program can prevent, that it is killed between two renamings, the
/// next update finds by the journal, and puts the old state back (`restore_foam_case`). A solver
/// that is started on such a case ends with an error, since `FoamChanges::key` is missing.
///
/// A file that is a link stays one: the file that it names is changed.
class FoamUpdate {
public:
    /// @throws IoError if the case cannot be written in, or another process is updating it
    explicit FoamUpdate(const std::filesystem::path& foam_case);

    /// Where the new files are written, by their paths in the case.
    const std::filesystem::path& staging() const { return staging_; }

    /// @param before_step  called before each renaming; tests end the process there
    /// @throws IoError if a file cannot be put in its place; the case then is as it was
    void commit(const FoamChanges& changes, const std::function<void()>& before_step = {});

private:
    std::filesystem::path room_for(const std::filesystem::path& target);

    std::filesystem::path case_;
    WorkingFolder working_;
    std::filesystem::path staging_;
    /// Beside targets that lie on another file system than the case, by their folders.
    std::map<std::filesystem::path, std::unique_ptr<WorkingFolder>> elsewhere_;
};

/// Puts the old state of a case back if a process was killed while it changed the case. Files that
/// were changed since by others stay as they are. Does nothing to any other case or folder.
/// @throws IoError if that fails, or another process is updating the case
void restore_foam_case(const std::filesystem::path& foam_case);

}  // namespace braidzone
