#include "core/working_folder.hpp"

#include "core/error.hpp"
#include "core/file_hash.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <vector>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

constexpr const char* owner_file = "owner";

/// Between a folder's making and its lock lie microseconds: one without a lock file that is older
/// than this was left.
constexpr auto longest_making = std::chrono::seconds(60);

std::string first_line(const fs::path& file)
{
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::string host_name()
{
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

/// Another one after each start of the kernel.
std::string kernel_start()
{
    return first_line("/proc/sys/kernel/random/boot_id");
}

std::string prefix_of(const std::string& output)
{
    return fmt::format(".braidzone.{}.", sha256_of_text(output).substr(0, 16));
}

bool is_of_this_machine(const fs::path& folder)
{
    std::ifstream stream(folder / owner_file);
    std::string host, start;
    std::getline(stream, host);
    std::getline(stream, start);
    // Killed before it was written: the lock alone decides.
    if (host.empty()) return true;
    return host == host_name() || (!start.empty() && start == kernel_start());
}

bool is_same_file(int descriptor, const fs::path& path)
{
    struct stat opened = {}, found = {};
    return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &found) == 0 &&
           opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

/// Locks a new folder's owner file and says in it who that is.
/// @return the descriptor, or -1 if another process has just taken the folder for one that was left
int take(const fs::path& folder, const std::string& output)
{
    const fs::path file = folder / owner_file;
    const int owner = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (owner < 0) return -1;
    const bool is_taken = ::flock(owner, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (is_taken || !is_same_file(owner, file)) {
        ::close(owner);
        return -1;
    }
    const std::string text =
        fmt::format("{}\n{}\n{}\n{}\n", host_name(), kernel_start(), ::getpid(), output);
    // On a full disk it stays empty; what is written next will say so.
    [[maybe_unused]] const auto written = ::write(owner, text.data(), text.size());
    return owner;
}

bool was_left_unlocked(const fs::path& folder)
{
    std::error_code error;
    const auto changed = fs::last_write_time(folder, error);
    return !error && fs::file_time_type::clock::now() - changed > longest_making;
}

/// Removes all but the lock file, then this: a folder half removed still has its owner.
void remove_folder(const fs::path& folder)
{
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename() != owner_file) fs::remove_all(entry.path(), ignored);
    fs::remove_all(folder, ignored);
}

std::vector<fs::path> working_folders(const fs::path& parent, const std::string& output)
{
    std::vector<fs::path> folders;
    const std::string prefix = prefix_of(output);
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(parent, error)) {
        if (entry.path().filename().string().starts_with(prefix)) folders.push_back(entry.path());
    }
    return folders;
}

}  // namespace

WorkingFolder::WorkingFolder(const fs::path& parent, const std::string& output)
{
    clear_working_folders(parent, output);
    for (int attempt = 0; attempt < 10000; ++attempt) {
        const fs::path folder =
            parent / fmt::format("{}{}-{}.unfinished", prefix_of(output), ::getpid(), attempt);
        if (UnfinishedOutput::without_signals([&] { return try_to_make(folder, output); })) return;
    }
    throw IoError(fmt::format("no working folder can be made in {}", parent.string()));
}

/// @return false if there is one of that name, or another process took it for one that was left
bool WorkingFolder::try_to_make(const fs::path& folder, const std::string& output)
{
    if (::mkdir(folder.c_str(), 0777) != 0) {
        if (errno == EEXIST) return false;
        throw IoError(fmt::format("nothing can be written in {}: {}", folder.parent_path().string(),
                                  std::strerror(errno)));
    }
    owner_ = take(folder, output);
    if (owner_ < 0) {
        remove_folder(folder);
        return false;
    }
    unfinished_.emplace(folder);
    return true;
}

WorkingFolder::~WorkingFolder()
{
    unfinished_.reset();  // while it is still locked
    if (owner_ >= 0) ::close(owner_);
}

void WorkingFolder::remove() const
{
    remove_folder(path());
}

bool clear_working_folders(const fs::path& parent, const std::string& output,
                           const std::function<void(const fs::path&)>& before)
{
    bool is_one_alive = false;
    for (const fs::path& folder : working_folders(parent, output)) {
        const fs::path file = folder / owner_file;
        const int owner = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
        if (owner < 0) {
            if (errno == ENOENT && was_left_unlocked(folder)) remove_folder(folder);
            continue;
        }
        const bool is_locked = ::flock(owner, LOCK_EX | LOCK_NB) != 0;
        if (is_locked) {
            is_one_alive = is_one_alive || errno == EWOULDBLOCK;
        } else if (is_of_this_machine(folder) && is_same_file(owner, file)) {
            if (before) before(folder);
            remove_folder(folder);
        }
        ::close(owner);
    }
    return is_one_alive;
}

}  // namespace braidzone
