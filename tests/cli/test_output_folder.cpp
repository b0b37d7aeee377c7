#include "cli/output_files.hpp"
#include "cli/output_folder.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

constexpr auto summary_of_a_run = R"({"program": "braidzone"})";

void write(const fs::path& file, const std::string& text)
{
    std::ofstream(file) << text;
}

int num_entries(const fs::path& folder)
{
    return static_cast<int>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::string text_of(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// As a run does; each file holds its name.
std::string write_run(const fs::path& out, const std::vector<std::string>& files)
{
    OutputFolder folder(out, {}, false);
    for (const std::string& file : files) {
        fs::create_directories((folder.path() / file).parent_path());
        write(folder.path() / file, file);
    }
    write(folder.path() / "summary.json", summary_of_a_run);
    return folder.commit();
}

TEST(OutputFolder, AppearsWholeAtTheEnd)
{
    const test::TemporaryFolder place;
    const fs::path wanted = place.path() / "new" / "out";
    OutputFolder folder(wanted, {}, false);
    write(folder.path() / "a", "1");
    EXPECT_FALSE(fs::exists(wanted));
    folder.commit();
    EXPECT_TRUE(fs::exists(wanted / "a"));
    EXPECT_EQ(num_entries(wanted.parent_path()), 1);
}

TEST(OutputFolder, LeavesNothingUnlessCommitted)
{
    const test::TemporaryFolder place;
    {
        OutputFolder folder(place.path() / "out", {}, false);
        write(folder.path() / "a", "1");
    }
    EXPECT_EQ(num_entries(place.path()), 0);
}

TEST(OutputFolder, ReplacesThatOfAnEarlierRun)
{
    const test::TemporaryFolder place;
    write_run(place.path() / "out", {"old", "openfoam/0/U"});
    OutputFolder folder(place.path() / "out/", {}, false);  // a trailing slash changes nothing
    write(folder.path() / "new", "1");
    EXPECT_TRUE(fs::exists(place.path() / "out" / "old"));
    EXPECT_EQ(folder.commit(), "");
    EXPECT_FALSE(fs::exists(place.path() / "out" / "old"));
    EXPECT_FALSE(fs::exists(place.path() / "out" / "openfoam"));
    EXPECT_TRUE(fs::exists(place.path() / "out" / "new"));
    EXPECT_EQ(num_entries(place.path()), 1);
}

TEST(OutputFolder, KeepsWhatTheUserPutBesideTheResults)
{
    const test::TemporaryFolder place;
    write_run(place.path() / "out", {"old"});
    place.write("out/notes.txt", "mine");
    place.write("out/figures/a.png", "mine");
    EXPECT_EQ(write_run(place.path() / "out", {"new"}), "");
    EXPECT_EQ(text_of(place.path() / "out/notes.txt"), "mine");
    EXPECT_EQ(text_of(place.path() / "out/figures/a.png"), "mine");
    EXPECT_FALSE(fs::exists(place.path() / "out/old"));
    EXPECT_EQ(num_entries(place.path()), 1);
}

TEST(OutputFolder, KeepsAnEarlierFolderInWhichASolverWrote)
{
    const test::TemporaryFolder place;
    const fs::path out = place.path() / "out";
    for (int number = 1; number <= 2; ++number) {
        write_run(out, {"device.vtp", "openfoam/system/controlDict"});
        place.write("out/openfoam/1000/U", "solved");
        place.write("out/notes.txt", "mine");
        const std::string kept = write_run(out, {"device.vtp"});
        const fs::path aside = out.string() + ".kept-" + std::to_string(number);
        EXPECT_NE(kept.find(aside.string()), std::string::npos) << kept;
        EXPECT_NE(kept.find("openfoam/1000"), std::string::npos) << kept;
        EXPECT_EQ(text_of(aside / "openfoam/1000/U"), "solved");
        EXPECT_TRUE(fs::exists(aside / "openfoam/system/controlDict"));
        EXPECT_TRUE(fs::exists(aside / "summary.json"));
        EXPECT_EQ(text_of(out / "notes.txt"), "mine");
        EXPECT_FALSE(fs::exists(out / "openfoam"));
    }
    EXPECT_EQ(num_entries(place.path()), 3);
}

TEST(OutputFolder, KeepsAnEarlierFolderInWhichAFileWasChanged)
{
    for (const char* file : {"openfoam/system/controlDict", "summary.json"}) {
        const test::TemporaryFolder place;
        const fs::path out = place.path() / "out";
        write_run(out, {"openfoam/system/controlDict"});
        // As long as before, and of the same time.
        const auto time = fs::last_write_time(out / file);
        std::string text = text_of(out / file);
        text.back() = '#';
        write(out / file, text);
        fs::last_write_time(out / file, time);
        EXPECT_NE(write_run(out, {"a"}).find(file), std::string::npos);
        EXPECT_EQ(text_of(place.path() / "out.kept-1" / file), text);
    }
}

TEST(OutputFolder, KeepsAFileThatTheNewRunWouldOverwrite)
{
    const test::TemporaryFolder place;
    write_run(place.path() / "out", {"a"});
    place.write("out/laws.csv", "mine");
    write_run(place.path() / "out", {"laws.csv"});
    EXPECT_EQ(text_of(place.path() / "out.kept-1/laws.csv"), "mine");
    EXPECT_EQ(text_of(place.path() / "out/laws.csv"), "laws.csv");
}

// Versions before this one wrote no hashes.
TEST(OutputFolder, KeepsAnEarlierFolderWithoutARecord)
{
    const test::TemporaryFolder place;
    place.write("out/summary.json", summary_of_a_run);
    place.write("out/device.vtp", "1");
    EXPECT_NE(write_run(place.path() / "out", {"a"}), "");
    EXPECT_EQ(text_of(place.path() / "out.kept-1/device.vtp"), "1");
}

TEST(OutputFolder, KeepsWhatIsWrittenWhileItRuns)
{
    const test::TemporaryFolder place;
    write_run(place.path() / "out", {"openfoam/0/U"});
    OutputFolder folder(place.path() / "out", {}, false);
    place.write("out/openfoam/1/U", "solved");
    EXPECT_NE(folder.commit(), "");
    EXPECT_EQ(text_of(place.path() / "out.kept-1/openfoam/1/U"), "solved");
}

TEST(OutputFolder, IsNeverOneThatHoldsAnInput)
{
    const test::TemporaryFolder place;
    const fs::path input = place.write("out/in/vessel.stl", "1");
    write(place.path() / "out/summary.json", summary_of_a_run);
    fs::create_directory_symlink(place.path() / "out", place.path() / "link");
    fs::create_symlink(input, place.path() / "vessel.stl");
    for (const bool force : {false, true}) {
        for (const char* folder : {".", "out", "out/in", "link", "link/in"}) {
            EXPECT_THROW(OutputFolder(place.path() / folder, {{"vessel", input}}, force),
                         ConfigError)
                << folder;
        }
        EXPECT_THROW(
            OutputFolder(place.path() / "out", {{"vessel", place.path() / "vessel.stl"}}, force),
            ConfigError);
    }
    EXPECT_EQ(text_of(input), "1");
    EXPECT_NO_THROW(OutputFolder(place.path() / "out/new", {{"vessel", input}}, false));
}

TEST(OutputFolder, IsNeverTheCurrentOrTheHomeFolderOrAboveThem)
{
    const test::TemporaryFolder place;
    const fs::path before = fs::current_path();
    place.write("out/inner/a", "1");
    fs::current_path(place.path() / "out/inner");
    EXPECT_THROW(OutputFolder(place.path() / "out", {}, true), ConfigError);
    EXPECT_THROW(OutputFolder(place.path() / "out/inner", {}, true), ConfigError);
    fs::current_path(before);
    const std::string home = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
    ::setenv("HOME", (place.path() / "out/inner").c_str(), 1);
    EXPECT_THROW(OutputFolder(place.path() / "out", {}, true), ConfigError);
    ::setenv("HOME", home.c_str(), 1);
    EXPECT_TRUE(fs::exists(place.path() / "out/inner/a"));
}

TEST(OutputFolder, MayHaveALongName)
{
    const test::TemporaryFolder place;
    const fs::path wanted = place.path() / std::string(245, 'n');
    write_run(wanted, {"a"});
    write_run(wanted, {"b"});
    EXPECT_TRUE(fs::exists(wanted / "b"));
    EXPECT_EQ(num_entries(place.path()), 1);
}

// A child process ends without a destructor, as a killed one does.
TEST(OutputFolder, ClearsWhatAnEndedProcessLeftAndNothingElse)
{
    const test::TemporaryFolder place;
    const fs::path wanted = place.path() / "out";
    const pid_t child = ::fork();
    if (child == 0) {
        const OutputFolder left(wanted, {}, false);
        ::raise(SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(num_entries(place.path()), 1);
    OutputFolder running(wanted, {}, false);
    EXPECT_EQ(num_entries(place.path()), 1);
    OutputFolder second(wanted, {}, false);
    EXPECT_EQ(num_entries(place.path()), 2);
    write(running.path() / "a", "1");
    running.commit();
    EXPECT_TRUE(fs::exists(wanted / "a"));
}

TEST(OutputFolder, ReplacesAnyOtherByForceOnly)
{
    const test::TemporaryFolder place;
    for (const char* text : {"not JSON", "{}", R"({"program": 3})", "[]"}) {
        place.write("out/summary.json", text);
        EXPECT_THROW(OutputFolder(place.path() / "out", {}, false), IoError) << text;
    }
    fs::create_directory(place.path() / "empty");
    EXPECT_THROW(OutputFolder(place.path() / "empty", {}, false), IoError);
    OutputFolder forced(place.path() / "out", {}, true);
    forced.commit();
    EXPECT_FALSE(fs::exists(place.path() / "out" / "summary.json"));
}

TEST(OutputFiles, AppearTogetherAtTheEnd)
{
    const test::TemporaryFolder place;
    OutputFiles files({}, false);
    const fs::path first = files.add(place.path() / "a.stl");
    write(first, "1");
    write(files.add(place.path() / "b.vtp"), "2");
    EXPECT_EQ(first.extension(), ".stl");
    EXPECT_FALSE(fs::exists(place.path() / "a.stl"));
    files.commit();
    EXPECT_TRUE(fs::exists(place.path() / "a.stl"));
    EXPECT_TRUE(fs::exists(place.path() / "b.vtp"));
    EXPECT_EQ(num_entries(place.path()), 2);
}

TEST(TextOutput, RefusesAPathBeforeTheWorkAndWritesTheTextWhole)
{
    const test::TemporaryFolder place;
    const auto path = place.path() / "table.csv";
    {
        TextOutput output(path, {}, false);
        EXPECT_FALSE(std::filesystem::exists(path));
        output.write("a,b\n");
        EXPECT_EQ(output.path(), path);
    }
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "a,b");
    EXPECT_THROW(TextOutput(path, {}, false), IoError);
    EXPECT_NO_THROW(TextOutput(path, {}, true));
}

TEST(OutputFiles, ReplaceAFileByForceOnly)
{
    const test::TemporaryFolder place;
    place.write("a.stl", "old");
    EXPECT_THROW(OutputFiles({}, false).add(place.path() / "a.stl"), IoError);
    OutputFiles files({}, true);
    write(files.add(place.path() / "a.stl"), "longer");
    files.commit();
    EXPECT_EQ(fs::file_size(place.path() / "a.stl"), 6u);
}

TEST(OutputFiles, AreNeverAnInput)
{
    const test::TemporaryFolder place;
    const fs::path input = place.write("a.stl", "in");
    fs::create_symlink(input, place.path() / "link.stl");
    for (const char* name : {"a.stl", "link.stl"})
        EXPECT_THROW(OutputFiles({{"surface", input}}, true).add(place.path() / name), ConfigError);
    EXPECT_EQ(text_of(input), "in");
}

// A file of another kind cannot take the place of a folder; that is found before the work.
TEST(OutputFiles, AreNeverAFolder)
{
    const test::TemporaryFolder place;
    EXPECT_THROW(OutputFiles({}, true).add(place.path()), IoError);
}

}  // namespace
}  // namespace braidzone
