#include "core/error.hpp"
#include "deploy/spacing_table.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

class SpacingTable : public testing::Test {
protected:
    std::vector<SpacingPoint> read(const std::string& text)
    {
        return read_spacing_table(folder_.write("spacing.csv", text));
    }

    std::string message(const std::string& text)
    {
        try {
            read(text);
        } catch (const InputError& error) {
            const std::string what = error.what();
            return what.substr(what.find("spacing.csv"));
        }
        return "accepted";
    }

    test::TemporaryFolder folder_;
};

TEST_F(SpacingTable, ReadsTheUnitOfItsHeader)
{
    const auto table = read("s_mm,lambda\n2,1.0\n 12.5 , 0.34\r\n\n");
    ASSERT_EQ(table.size(), 2u);
    EXPECT_DOUBLE_EQ(table[0].arc_length, 2e-3);
    EXPECT_EQ(table[0].spacing, 1.0);
    EXPECT_DOUBLE_EQ(table[1].arc_length, 12.5e-3);
    EXPECT_EQ(table[1].spacing, 0.34);
    EXPECT_DOUBLE_EQ(read("s_cm,lambda\n0,1\n2,1\n")[1].arc_length, 0.02);
    EXPECT_DOUBLE_EQ(read("s_um,lambda\n0,1\n2,1\n")[1].arc_length, 2e-6);
    EXPECT_DOUBLE_EQ(read("s_m,lambda\n0,1\n2,1\n")[1].arc_length, 2.0);
}

TEST_F(SpacingTable, IsReturnedWithIncreasingArcLength)
{
    const auto table = read("s_mm,lambda\n20,1.0\n10,0.5\n5,1.2\n");
    ASSERT_EQ(table.size(), 3u);
    EXPECT_DOUBLE_EQ(table.front().arc_length, 5e-3);
    EXPECT_EQ(table.front().spacing, 1.2);
    EXPECT_DOUBLE_EQ(table.back().arc_length, 20e-3);
}

TEST_F(SpacingTable, RefusesWhatIsNoTableAndNamesTheLine)
{
    EXPECT_EQ(message("s,lambda\n1,1\n2,1\n"),
              "spacing.csv:1: \"s,lambda\" is not the header of a spacing table; expected is "
              "s_mm,lambda (or s_m, s_cm, s_um)");
    EXPECT_EQ(message(""),
              "spacing.csv:1: \"\" is not the header of a spacing table; expected is s_mm,lambda "
              "(or s_m, s_cm, s_um)");
    EXPECT_EQ(message("s_mm,lambda\n1,1\n2;1\n"),
              "spacing.csv:3: \"2;1\" is not a point of the table; expected are two numbers with a "
              "comma between");
    EXPECT_EQ(message("s_mm,lambda\n1,1\n2,1,0\n"),
              "spacing.csv:3: \"2,1,0\" is not a point of the table; expected are two numbers with "
              "a comma between");
    EXPECT_EQ(message("s_mm,lambda\n1,1\ninf,1\n"),
              "spacing.csv:3: \"inf,1\" is not a point of the table; expected are two numbers with "
              "a comma between");
    EXPECT_EQ(message("s_mm,lambda\n1,1\n\n2,1\n"),
              "spacing.csv:3: is empty; a point of the table is expected");
    EXPECT_EQ(message("s_mm,lambda\n1,1\n2,1\n1.5,1\n"),
              "spacing.csv:4: arc length 1.5 follows 2; arc lengths must go one way");
    EXPECT_EQ(message("s_mm,lambda\n1,1\n1,1\n"),
              "spacing.csv:3: arc length 1 follows 1; arc lengths must go one way");
    EXPECT_EQ(message("s_mm,lambda\n1,1\n"),
              "spacing.csv:2: the table has 1 points; at least 2 are expected");
    EXPECT_EQ(message("s_mm,lambda\n1,1\n2,9\n"),
              "spacing.csv: spacing_table: lambda = 9 at 2 mm; allowed are 0.05 to 4 times the "
              "nominal spacing");
}

TEST_F(SpacingTable, RefusesAFileThatIsNotThere)
{
    EXPECT_THROW(read_spacing_table(folder_.path() / "absent.csv"), IoError);
}

}  // namespace
}  // namespace braidzone
