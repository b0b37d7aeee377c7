#include "cli/output_folder.hpp"

#include "cli/summary.hpp"
#include "core/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

void require_replaceable(const fs::path& folder, bool force, const std::string& record)
{
    if (!fs::exists(fs::symlink_status(folder))) return;
    if (!fs::is_directory(folder)) {
        throw IoError(fmt::format("output folder {} is a file", folder.string()));
    }
    if (force || is_summary_of_a_run(folder / record)) return;
    throw IoError(
        fmt::format("output folder {} exists and no earlier run wrote it (it holds no "
                    "{} of a run); choose another with --output, or replace it "
                    "with --force",
                    folder.string(), record));
}

/// Two folders change places in one step. False if the file system cannot do that.
bool exchange(const fs::path& first, const fs::path& second)
{
    return ::renameat2(AT_FDCWD, first.c_str(), AT_FDCWD, second.c_str(), RENAME_EXCHANGE) == 0;
}

void move_to(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::rename(from, to, error);
    if (error) {
        throw IoError(fmt::format("{} cannot be renamed to {}: {}", from.string(), to.string(),
                                  error.message()));
    }
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& wanted, bool force, const std::string& record)
{
    // A trailing slash would make the last component empty.
    const fs::path absolute = fs::absolute(wanted / "").lexically_normal().parent_path();
    std::error_code error;
    wanted_ = fs::weakly_canonical(absolute, error);
    if (error) wanted_ = absolute;
    require_replaceable(wanted_, force, record);

    const fs::path sibling =
        wanted_.parent_path() /
        fmt::format(".{}.{}.unfinished", wanted_.filename().string(), ::getpid());
    unfinished_.emplace(sibling);
    fs::create_directories(sibling, error);
    if (error) {
        throw IoError(fmt::format("output folder {} cannot be created: {}", wanted_.string(),
                                  error.message()));
    }
}

void OutputFolder::commit()
{
    unfinished_->finish([&] {
        if (!fs::exists(wanted_)) {
            move_to(path(), wanted_);
            return;
        }
        if (!exchange(path(), wanted_)) {
            const fs::path old = path().string() + ".old";
            move_to(wanted_, old);
            move_to(path(), wanted_);
            move_to(old, path());
        }
        fs::remove_all(path());  // the earlier folder, which is there now
    });
}

}  // namespace braidzone
