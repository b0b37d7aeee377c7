#include "cli/output_files.hpp"
#include "cli/output_folder.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

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

TEST(OutputFolder, AppearsWholeAtTheEnd)
{
    const test::TemporaryFolder place;
    const fs::path wanted = place.path() / "new" / "out";
    OutputFolder folder(wanted, false);
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
        OutputFolder folder(place.path() / "out", false);
        write(folder.path() / "a", "1");
    }
    EXPECT_EQ(num_entries(place.path()), 0);
}

TEST(OutputFolder, ReplacesThatOfAnEarlierRun)
{
    const test::TemporaryFolder place;
    place.write("out/summary.json", summary_of_a_run);
    place.write("out/old", "1");
    OutputFolder folder(place.path() / "out/", false);  // a trailing slash changes nothing
    write(folder.path() / "new", "1");
    EXPECT_TRUE(fs::exists(place.path() / "out" / "old"));
    folder.commit();
    EXPECT_FALSE(fs::exists(place.path() / "out" / "old"));
    EXPECT_TRUE(fs::exists(place.path() / "out" / "new"));
    EXPECT_EQ(num_entries(place.path()), 1);
}

TEST(OutputFolder, ReplacesAnyOtherByForceOnly)
{
    const test::TemporaryFolder place;
    for (const char* text : {"not JSON", "{}", R"({"program": 3})", "[]"}) {
        place.write("out/summary.json", text);
        EXPECT_THROW(OutputFolder(place.path() / "out", false), IoError) << text;
    }
    fs::create_directory(place.path() / "empty");
    EXPECT_THROW(OutputFolder(place.path() / "empty", false), IoError);
    OutputFolder forced(place.path() / "out", true);
    forced.commit();
    EXPECT_FALSE(fs::exists(place.path() / "out" / "summary.json"));
}

TEST(OutputFiles, AppearTogetherAtTheEnd)
{
    const test::TemporaryFolder place;
    OutputFiles files(false);
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
        TextOutput output(path, false);
        EXPECT_FALSE(std::filesystem::exists(path));
        output.write("a,b\n");
        EXPECT_EQ(output.path(), path);
    }
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "a,b");
    EXPECT_THROW(TextOutput(path, false), IoError);
    EXPECT_NO_THROW(TextOutput(path, true));
}

TEST(OutputFiles, ReplaceAFileByForceOnly)
{
    const test::TemporaryFolder place;
    place.write("a.stl", "old");
    EXPECT_THROW(OutputFiles(false).add(place.path() / "a.stl"), IoError);
    OutputFiles files(true);
    write(files.add(place.path() / "a.stl"), "longer");
    files.commit();
    EXPECT_EQ(fs::file_size(place.path() / "a.stl"), 6u);
}

}  // namespace
}  // namespace braidzone
