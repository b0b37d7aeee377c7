#include "core/nearest_name.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps)
{
    EXPECT_EQ(edit_distance("", ""), 0);
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);  // the textbook example: k-s, e-i, +g
    EXPECT_EQ(edit_distance("lenght", "length"), 1);   // one swap
    EXPECT_EQ(edit_distance("diameter", "diametre"), 1);
}

TEST(EditDistance, IsSymmetric)
{
    EXPECT_EQ(edit_distance("silk-plus", "silk"), edit_distance("silk", "silk-plus"));
}

TEST(DidYouMean, NamesTheNearestIfItIsNear)
{
    EXPECT_EQ(did_you_mean("diametre", {"length", "diameter"}), "; did you mean \"diameter\"?");
}

TEST(DidYouMean, ListsAllIfNoneIsNear)
{
    EXPECT_EQ(did_you_mean("colour", {"length", "diameter"}), "; known are length, diameter");
}

TEST(DidYouMean, IsEmptyIfNothingIsKnown)
{
    EXPECT_EQ(did_you_mean("colour", {}), "");
}

}  // namespace
}  // namespace braidzone
