#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/working_folder.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <iterator>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

int num_entries(const fs::path& folder)
{
    return static_cast<int>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A process with a working folder in `parent`, stopped until it is told to go on.
class Worker {
public:
    Worker(const fs::path& parent, const std::string& output)
    {
        std::array<int, 2> ready = {};
        EXPECT_EQ(::pipe(ready.data()), 0);
        process_ = ::fork();
        if (process_ == 0) {
            remove_unfinished_output_on_signal();
            const WorkingFolder folder(parent, output);
            std::ofstream(folder.path() / "part") << "1";
            if (::write(ready[1], "1", 1) != 1) ::_exit(1);
            while (true)
                ::pause();
        }
        char byte = 0;
        EXPECT_EQ(::read(ready[0], &byte, 1), 1);
        ::close(ready[0]);
        ::close(ready[1]);
    }

    void end_by(int signal)
    {
        ::kill(process_, signal);
        ::waitpid(process_, nullptr, 0);
    }

private:
    pid_t process_ = -1;
};

TEST(WorkingFolder, IsHiddenBesideTheOutputAndGoneAtTheEnd)
{
    const test::TemporaryFolder place;
    {
        const WorkingFolder folder(place.path(), "case.out");
        EXPECT_EQ(folder.path().parent_path(), place.path());
        EXPECT_EQ(folder.path().filename().string().front(), '.');
        EXPECT_TRUE(fs::is_directory(folder.path()));
    }
    EXPECT_EQ(num_entries(place.path()), 0);
}

TEST(WorkingFolder, IsMovedAndThenGone)
{
    const test::TemporaryFolder place;
    WorkingFolder folder(place.path(), "a");
    std::ofstream(folder.path() / "made") << "1";
    folder.finish([&] { fs::rename(folder.path() / "made", place.path() / "a"); });
    EXPECT_EQ(num_entries(place.path()), 1);
    EXPECT_TRUE(fs::exists(place.path() / "a"));
}

// INT, TERM and HUP remove it at once. KILL leaves it, and the next process of the same output,
// not one of another output, removes it.
TEST(WorkingFolder, OfAProcessThatEndedIsCleared)
{
    const test::TemporaryFolder place;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
        Worker worker(place.path(), "out");
        EXPECT_EQ(num_entries(place.path()), 1);
        worker.end_by(signal);
        EXPECT_EQ(num_entries(place.path()), signal == SIGKILL ? 1 : 0) << signal;
    }
    {
        const WorkingFolder other(place.path(), "other");
    }
    EXPECT_EQ(num_entries(place.path()), 1);
    {
        const WorkingFolder next(place.path(), "out");
    }
    EXPECT_EQ(num_entries(place.path()), 0);
}

TEST(WorkingFolder, OfAProcessThatLivesIsLeft)
{
    const test::TemporaryFolder place;
    Worker worker(place.path(), "out");
    EXPECT_TRUE(clear_working_folders(place.path(), "out"));
    {
        const WorkingFolder next(place.path(), "out");
    }
    EXPECT_EQ(num_entries(place.path()), 1);
    worker.end_by(SIGKILL);
    int num_seen = 0;
    EXPECT_FALSE(clear_working_folders(place.path(), "out", [&](const fs::path& folder) {
        num_seen += fs::exists(folder / "part");
    }));
    EXPECT_EQ(num_seen, 1);
    EXPECT_EQ(num_entries(place.path()), 0);
}

// What happens to have such a name and is nobody's working folder stays.
TEST(WorkingFolder, IsNeverAFolderOfTheUser)
{
    const test::TemporaryFolder place;
    place.write(".braidzone.notes.unfinished/a", "1");
    place.write(".case.unfinished/a", "1");
    {
        const WorkingFolder folder(place.path(), "case");
    }
    EXPECT_TRUE(fs::exists(place.path() / ".braidzone.notes.unfinished/a"));
    EXPECT_TRUE(fs::exists(place.path() / ".case.unfinished/a"));
}

TEST(WorkingFolder, NeedsAPlaceToBeMade)
{
    const test::TemporaryFolder place;
    EXPECT_THROW(WorkingFolder(place.path() / "absent", "case"), IoError);
}

}  // namespace
}  // namespace braidzone
