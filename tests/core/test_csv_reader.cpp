#include "core/csv_reader.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

TEST(CsvReader, GivesLinesWithoutTheirEnds)
{
    const test::TemporaryFolder folder;
    CsvReader reader(folder.write("a.csv", "x,y\r\n1,2\n\n3,4"));
    EXPECT_EQ(reader.header(), "x,y");
    EXPECT_EQ(reader.line_number(), 1);
    EXPECT_EQ(reader.next(), "1,2");
    EXPECT_EQ(reader.next(), "");
    EXPECT_EQ(reader.next(), "3,4");
    EXPECT_EQ(reader.line_number(), 4);
    EXPECT_EQ(reader.next(), std::nullopt);
    EXPECT_EQ(reader.line_number(), 4);
}

TEST(CsvReader, RefusesWithFileAndLine)
{
    const test::TemporaryFolder folder;
    const auto path = folder.write("a.csv", "x\n1\n");
    CsvReader reader(path);
    reader.next();
    EXPECT_EQ(std::string(reader.refusal("is odd").what()), path.string() + ":2: is odd");
    EXPECT_EQ(std::string(reader.refusal(1, "is odd").what()), path.string() + ":1: is odd");
}

TEST(CsvReader, AnEmptyFileHasAnEmptyHeader)
{
    const test::TemporaryFolder folder;
    CsvReader reader(folder.write("a.csv", ""));
    EXPECT_EQ(reader.header(), "");
    EXPECT_EQ(reader.next(), std::nullopt);
}

TEST(CsvReader, NeedsAFile)
{
    EXPECT_THROW(CsvReader("/nowhere/a.csv"), IoError);
}

}  // namespace
}  // namespace braidzone
