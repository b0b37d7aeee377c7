#include "cli/output_folder.hpp"

#include "cli/output_place.hpp"
#include "cli/summary.hpp"
#include "core/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

void require_no_file(const fs::path& folder)
{
    if (!fs::exists(fs::symlink_status(folder)) || fs::is_directory(folder)) return;
    throw IoError(fmt::format("output folder {} is a file", folder.string()));
}

void require_replaceable(const fs::path& folder, bool force, const std::string& record)
{
    if (!fs::exists(fs::symlink_status(folder))) return;
    if (force || is_summary_of_a_run(folder / record) || is_recorded(folder, record)) return;
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

/// "DIR.kept-1", or the next number that is free.
fs::path place_to_keep(const fs::path& folder)
{
    for (int number = 1;; ++number) {
        const fs::path place = fmt::format("{}.kept-{}", folder.string(), number);
        if (!fs::exists(fs::symlink_status(place))) return place;
    }
}

/// The first of them, for a message.
std::string some_of(const std::vector<fs::path>& files)
{
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const fs::path& file : files)
        if (names.size() < most) names.push_back(file.string());
    const std::string text = fmt::format("{}", fmt::join(names, ", "));
    return files.size() <= most ? text : fmt::format("{} and {} more", text, files.size() - most);
}

std::string moved_aside(const fs::path& folder, const fs::path& kept,
                        const std::vector<fs::path>& altered)
{
    const std::string reason =
        altered.empty()
            ? "something was written into it meanwhile"
            : fmt::format("changed or added since it was written: {}", some_of(altered));
    return fmt::format("the earlier {} is kept as {} ({})", folder.filename().string(),
                       kept.string(), reason);
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& wanted, const std::vector<InputFile>& inputs, bool force,
                           const std::string& record)
    : inputs_(inputs), force_(force)
{
    // A trailing slash would make the last component empty.
    const fs::path absolute = fs::absolute(wanted / "").lexically_normal().parent_path();
    std::error_code error;
    wanted_ = fs::weakly_canonical(absolute, error);
    if (error) wanted_ = absolute;
    require_no_file(wanted_);
    require_holds_no_input(wanted_, inputs_);
    require_replaceable(wanted_, force, record);

    fs::create_directories(wanted_.parent_path(), error);
    if (error) {
        throw IoError(fmt::format("output folder {} cannot be created: {}", wanted_.string(),
                                  error.message()));
    }
    working_.emplace(wanted_.parent_path(), wanted_.filename().string());
    content_ = working_->path() / "new";
    fs::create_directory(content_);
}

std::string OutputFolder::commit()
{
    write_folder_record(content_);
    // Again: the run may have taken hours.
    require_holds_no_input(wanted_, inputs_);
    const bool is_new = !fs::exists(wanted_);
    FolderContents earlier;
    if (!is_new && !force_) earlier = compare_with_record(wanted_);

    std::string kept;
    working_->finish([&] {
        if (is_new)
            move_to(content_, wanted_);
        else if (force_)
            exchange_with(working_->path() / "old");
        else
            kept = replace(earlier);
    });
    return kept;
}

/// What others put into the earlier folder is in a place that can be seen, at any moment.
std::string OutputFolder::replace(const FolderContents& earlier)
{
    const fs::path aside = place_to_keep(wanted_);
    if (earlier.altered.empty() && earlier.own.empty()) {
        const fs::path old = working_->path() / "old";
        exchange_with(old);
        if (remove_found(old, earlier.unchanged)) return "";
        move_to(old, aside);
        return moved_aside(wanted_, aside, {});
    }
    exchange_with(aside);
    for (const fs::path& own : earlier.own)
        if (!fs::exists(fs::symlink_status(wanted_ / own))) move_to(aside / own, wanted_ / own);
    if (earlier.altered.empty() && remove_found(aside, earlier.unchanged)) return "";
    return moved_aside(wanted_, aside, earlier.altered);
}

/// The new folder comes to its place, and the one that was there to another.
void OutputFolder::exchange_with(const fs::path& place)
{
    move_to(content_, place);
    if (exchange(place, wanted_)) return;
    move_to(place, content_);
    move_to(wanted_, place);
    move_to(content_, wanted_);
}

void put_in_place(OutputFolder& folder)
{
    const std::string kept = folder.commit();
    if (!kept.empty()) fmt::print(stderr, "note: {}\n", kept);
}

}  // namespace braidzone
