#include "core/csv_fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {

TEST(CsvFields, AreWhatStandsBetweenCommas)
{
    EXPECT_THAT(csv_fields("a, b c ,\td\r"), testing::ElementsAre("a", "b c", "d"));
    EXPECT_THAT(csv_fields(""), testing::ElementsAre(""));
    EXPECT_THAT(csv_fields(",1,"), testing::ElementsAre("", "1", ""));
}

TEST(CsvNumber, IsAFiniteNumberAndNothingElse)
{
    EXPECT_EQ(csv_number("-1.5e-3"), -1.5e-3);
    for (const char* text : {"", "1 mm", "nan", "inf", "1e999", "0x10", "1,5"})
        EXPECT_FALSE(csv_number(text).has_value()) << text;
}

}  // namespace braidzone
