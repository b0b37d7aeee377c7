#include "export/foam_update.hpp"

#include "core/error.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <optional>
#include <sstream>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

constexpr const char* output_name = "export --onto";
constexpr const char* journal_file = "journal";

/// Tells a file from others; renaming keeps it.
struct FileIdentity {
    unsigned long long node = 0;
    long long size = 0, seconds = 0, nanoseconds = 0;
    bool operator==(const FileIdentity&) const = default;
};

/// One file of the case.
struct Change {
    fs::path target;
    fs::path fresh;  ///< comes to `target`; empty if that is removed
    fs::path old;    ///< what was there; empty if nothing was
    FileIdentity fresh_identity;
};

std::optional<FileIdentity> identity(const fs::path& file)
{
    struct stat found = {};
    if (::lstat(file.c_str(), &found) != 0) return std::nullopt;
    return FileIdentity{found.st_ino, found.st_size, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

void move_file(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::rename(from, to, error);
    if (error) throw IoError(fmt::format("{} cannot be written: {}", to.string(), error.message()));
}

void remove_file(const fs::path& file)
{
    std::error_code error;
    fs::remove(file, error);
    if (error)
        throw IoError(fmt::format("{} cannot be removed: {}", file.string(), error.message()));
}

void copy_over(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::copy_file(from, to, error);
    if (error)
        throw IoError(fmt::format("{} cannot be copied to {}: {}", from.string(), to.string(),
                                  error.message()));
}

/// The same file under a second name, or a copy where the file system has no such names.
void keep_copy(const fs::path& file, const fs::path& copy)
{
    std::error_code error;
    fs::create_hard_link(file, copy, error);
    if (error) copy_over(file, copy);
}

dev_t file_system_of(const fs::path& path)
{
    struct stat found = {};
    for (fs::path existing = path; ::stat(existing.c_str(), &found) != 0;) {
        if (existing == existing.parent_path()) return 0;
        existing = existing.parent_path();
    }
    return found.st_dev;
}

/// What the case holds of `file` and what will be there, in a folder on the same file system.
Change prepare(const fs::path& target, const fs::path& staged, const fs::path& room,
               std::size_t number)
{
    Change change;
    change.target = target;
    if (fs::is_directory(target))
        throw IoError(fmt::format("{} is a folder; a file is to be written there, or removed",
                                  target.string()));
    if (fs::exists(target)) {
        change.old = room / fmt::format("old.{}", number);
        keep_copy(target, change.old);
    }
    if (staged.empty()) return change;
    change.fresh = staged;
    if (file_system_of(staged) != file_system_of(room)) {
        change.fresh = room / fmt::format("new.{}", number);
        copy_over(staged, change.fresh);
    }
    change.fresh_identity = identity(change.fresh).value();
    return change;
}

std::string journal_text(const std::vector<Change>& changes, const fs::path& foam_case)
{
    std::ostringstream text;
    const auto path = [&](const fs::path& p) {
        return p.empty() ? "" : p.lexically_proximate(foam_case).string();
    };
    for (const Change& change : changes) {
        const FileIdentity& fresh = change.fresh_identity;
        text << std::quoted(path(change.target)) << ' ' << std::quoted(path(change.fresh)) << ' '
             << std::quoted(path(change.old)) << ' ' << fresh.node << ' ' << fresh.size << ' '
             << fresh.seconds << ' ' << fresh.nanoseconds << '\n';
    }
    return text.str();
}

std::vector<Change> read_journal(const fs::path& file, const fs::path& foam_case)
{
    std::ifstream text(file);
    std::vector<Change> changes;
    std::string target, fresh, old;
    FileIdentity id;
    while (text >> std::quoted(target) >> std::quoted(fresh) >> std::quoted(old) >> id.node >>
           id.size >> id.seconds >> id.nanoseconds) {
        const auto path = [&](const std::string& p) { return p.empty() ? "" : foam_case / p; };
        changes.push_back({path(target), path(fresh), path(old), id});
    }
    return changes;
}

bool is_fresh(const Change& change)
{
    return !change.fresh.empty() && identity(change.target) == change.fresh_identity;
}

/// Can be interrupted and done again. The last change, the key's, is undone last.
void undo(const std::vector<Change>& changes)
{
    if (!changes.empty() && is_fresh(changes.back())) remove_file(changes.back().target);
    for (const Change& change : changes) {
        const bool is_gone = !identity(change.target) && fs::exists(change.target.parent_path());
        const bool is_ours = is_fresh(change);
        if (!is_gone && !is_ours) continue;
        if (!change.old.empty() && fs::exists(change.old))
            move_file(change.old, change.target);
        else if (is_ours)
            remove_file(change.target);
    }
}

/// Takes the key away, changes the others, and puts the key in its place.
void carry_out(const std::vector<Change>& changes, const std::function<void()>& before_step)
{
    const auto step = [&](const auto& act) {
        if (before_step) before_step();
        act();
    };
    if (!changes.back().old.empty()) step([&] { remove_file(changes.back().target); });
    for (const Change& change : changes) {
        step([&] {
            if (change.fresh.empty())
                remove_file(change.target);
            else
                move_file(change.fresh, change.target);
        });
    }
}

/// Folders that a change needs and that are not there, the outermost first.
std::vector<fs::path> missing_folders(const std::vector<fs::path>& targets)
{
    std::vector<fs::path> missing;
    for (const fs::path& target : targets)
        for (fs::path folder = target.parent_path(); !fs::exists(folder);
             folder = folder.parent_path())
            missing.push_back(folder);
    std::sort(missing.begin(), missing.end());
    return missing;
}

fs::path canonical_case(const fs::path& foam_case)
{
    std::error_code error;
    const fs::path canonical = fs::canonical(foam_case, error);
    if (error)
        throw IoError(fmt::format("{} cannot be read: {}", foam_case.string(), error.message()));
    return canonical;
}

}  // namespace

FoamUpdate::FoamUpdate(const fs::path& foam_case)
    : case_(canonical_case(foam_case)),
      working_((restore_foam_case(case_), case_), output_name),
      staging_(working_.path() / "new")
{
    fs::create_directory(staging_);
}

fs::path FoamUpdate::room_for(const fs::path& target)
{
    const dev_t file_system = file_system_of(target.parent_path());
    if (file_system == file_system_of(working_.path())) return working_.path();
    auto& folder = elsewhere_[target.parent_path()];
    if (!folder) folder = std::make_unique<WorkingFolder>(target.parent_path(), output_name);
    return folder->path();
}

void FoamUpdate::commit(const FoamChanges& changes, const std::function<void()>& before_step)
{
    std::vector<Change> all;
    const auto add = [&](const fs::path& file, const fs::path& staged) {
        const fs::path target = fs::weakly_canonical(case_ / file);
        all.push_back(prepare(target, staged, room_for(target), all.size()));
    };
    for (const fs::path& file : changes.removed)
        if (fs::exists(case_ / file)) add(file, {});
    for (const fs::path& file : changes.written)
        if (file != changes.key) add(file, staging_ / file);
    add(changes.key, staging_ / changes.key);

    std::vector<fs::path> targets;
    for (const Change& change : all)
        targets.push_back(change.target);
    const std::vector<fs::path> folders = missing_folders(targets);
    // Whole or absent, as all that is read after a sudden end.
    const fs::path journal = working_.path() / journal_file;
    write_text_file(journal.string() + ".unfinished", journal_text(all, case_));

    working_.finish([&] {
        move_file(journal.string() + ".unfinished", journal);
        try {
            for (const fs::path& folder : folders)
                fs::create_directories(folder);
            carry_out(all, before_step);
        } catch (...) {
            try {
                undo(all);
            } catch (const Error& error) {
                working_.leave();
                for (auto& [folder, working] : elsewhere_)
                    working->leave();
                throw IoError(
                    fmt::format("{}; the case is half changed: repair that, and the next "
                                "export --onto puts its old state back",
                                error.what()));
            }
            remove_file(journal);
            for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
                fs::remove(*folder);
            throw;
        }
        remove_file(journal);
    });
}

void restore_foam_case(const fs::path& foam_case)
{
    std::error_code error;
    const fs::path place = fs::canonical(foam_case, error);
    if (error) return;  // reading it will say so
    const bool is_being_updated =
        clear_working_folders(place, output_name, [&](const fs::path& left) {
            undo(read_journal(left / journal_file, place));
            remove_file(left / journal_file);
        });
    if (is_being_updated)
        throw IoError(
            fmt::format("{}: another process is applying a device to this case", place.string()));
}

}  // namespace braidzone
