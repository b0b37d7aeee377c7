#include "core/error.hpp"
#include "export/foam_update.hpp"
#include "support/folder_contents.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <map>
#include <string>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

/// A case with a device, of which a file is replaced, one is new, one goes, and one is of the user.
class UpdatedCase : public testing::Test {
protected:
    void SetUp() override
    {
        folder_.write("constant/fdPorosity", "old");
        folder_.write("constant/fvOptions", "old");
        folder_.write("system/fdBaffles", "old");
        folder_.write("0/U", "user's");
    }

    void update(const std::function<void()>& before_step = {})
    {
        FoamUpdate change(folder_.path());
        for (const char* file : {"constant/fdPorosity", "constant/fvOptions", "new/fdZone"}) {
            fs::create_directories((change.staging() / file).parent_path());
            std::ofstream(change.staging() / file) << "new";
        }
        change.commit({.written = {"constant/fvOptions", "constant/fdPorosity", "new/fdZone"},
                       .removed = {"system/fdBaffles", "system/absent"},
                       .key = "constant/fdPorosity"},
                      before_step);
    }

    /// In a process that is killed before a step.
    void update_killed_before(int step)
    {
        const pid_t child = ::fork();
        if (child == 0) {
            int steps = 0;
            update([&] {
                if (steps++ == step) ::raise(SIGKILL);
            });
            ::_exit(0);
        }
        ::waitpid(child, nullptr, 0);
    }

    std::map<std::string, std::string> now() const { return test::folder_contents(folder_.path()); }

    test::TemporaryFolder folder_;
    const std::map<std::string, std::string> updated_ = {
        {"0", "folder"},        {"0/U", "user's"},
        {"constant", "folder"}, {"constant/fdPorosity", "new"},
        {"new", "folder"},      {"constant/fvOptions", "new"},
        {"system", "folder"},   {"new/fdZone", "new"}};
};

TEST_F(UpdatedCase, HasAllChanges)
{
    update();
    EXPECT_EQ(now(), updated_);
}

TEST_F(UpdatedCase, IsAsBeforeIfAFileCannotBeWritten)
{
    const auto before = now();
    for (int failing = 0; failing < 5; ++failing) {
        int steps = 0;
        EXPECT_THROW(update([&] {
                         if (steps++ == failing) throw IoError("no");
                     }),
                     IoError);
        EXPECT_EQ(now(), before) << failing;
    }
}

TEST_F(UpdatedCase, IsAsBeforeIfAFolderIsInTheWay)
{
    fs::create_directories(folder_.path() / "new/fdZone");
    const auto before = now();
    EXPECT_THROW(update(), IoError);
    EXPECT_EQ(now(), before);
}

// fdPorosity away, fdBaffles away, fvOptions, fdZone, fdPorosity: five steps.
TEST_F(UpdatedCase, IsRestoredAfterAKillBetweenAnyTwoSteps)
{
    const auto before = now();
    for (int step = 0; step < 5; ++step) {
        update_killed_before(step);
        if (step > 0) {
            EXPECT_NE(now(), before);
            EXPECT_FALSE(fs::exists(folder_.path() / "constant/fdPorosity")) << step;
        }
        restore_foam_case(folder_.path());
        auto restored = now();
        restored.erase("new");  // an empty folder may stay
        EXPECT_EQ(restored, before) << step;
    }
    update_killed_before(3);
    update();
    EXPECT_EQ(now(), updated_);
}

TEST_F(UpdatedCase, KeepsWhatOthersChangedAfterAKill)
{
    update_killed_before(4);
    folder_.write("constant/fvOptions", "user's, later");
    restore_foam_case(folder_.path());
    EXPECT_EQ(now()["constant/fvOptions"], "user's, later");
    EXPECT_EQ(now()["constant/fdPorosity"], "old");
}

TEST_F(UpdatedCase, IsNotUpdatedByTwo)
{
    const FoamUpdate running(folder_.path());
    EXPECT_THROW(update(), IoError);
}

TEST_F(UpdatedCase, ChangesTheFileThatALinkNames)
{
    const test::TemporaryFolder elsewhere;
    elsewhere.write("options", "old");
    fs::remove(folder_.path() / "constant/fvOptions");
    fs::create_symlink(elsewhere.path() / "options", folder_.path() / "constant/fvOptions");
    update();
    EXPECT_TRUE(fs::is_symlink(folder_.path() / "constant/fvOptions"));
    EXPECT_EQ(test::folder_contents(elsewhere.path())["options"], "new");
}

// /dev/shm is a file system of its own.
TEST_F(UpdatedCase, ReachesOtherFileSystems)
{
    const fs::path shm = "/dev/shm/braidzone_test_" + std::to_string(::getpid());
    std::error_code error;
    if (!fs::create_directories(shm / "constant", error)) GTEST_SKIP() << "no /dev/shm";
    fs::copy(folder_.path() / "constant", shm / "constant");
    fs::remove_all(folder_.path() / "constant");
    fs::create_directory_symlink(shm / "constant", folder_.path() / "constant");
    const auto before = test::folder_contents(shm);
    int steps = 0;
    EXPECT_THROW(update([&] {
                     if (steps++ == 4) throw IoError("no");
                 }),
                 IoError);
    EXPECT_EQ(test::folder_contents(shm), before);
    update_killed_before(4);
    restore_foam_case(folder_.path());
    update();
    auto after = test::folder_contents(shm);
    EXPECT_EQ(after["constant/fdPorosity"], "new");
    EXPECT_EQ(after["constant/fvOptions"], "new");
    EXPECT_EQ(after.size(), 3U);
    fs::remove_all(shm);
}

}  // namespace
}  // namespace braidzone
