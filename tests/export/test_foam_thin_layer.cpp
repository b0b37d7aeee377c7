#include "export/foam_thin_layer.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

// Entries of the table, as measured.
TEST(ThinLayerError, IsTheMeasuredOneAtTheTablesNodes)
{
    EXPECT_DOUBLE_EQ(thin_layer_error(1.0, 3.0), -0.27);
    EXPECT_DOUBLE_EQ(thin_layer_error(3.0, 300.0), -0.20);
    EXPECT_DOUBLE_EQ(thin_layer_error(6.0, 20.0), -0.037);
    EXPECT_DOUBLE_EQ(thin_layer_error(8.0, 2.0), -0.004);
}

// Between nodes: the mean of two in log K, by hand at K = sqrt(2 * 20).
TEST(ThinLayerError, IsLinearInTheLogarithmOfTheLoss)
{
    EXPECT_NEAR(thin_layer_error(6.0, 6.32455532), 0.5 * (-0.010 - 0.037), 1e-9);
}

// 1/n^2 halfway between 1/16 and 1/36: n = sqrt(2 / (1/16 + 1/36)) = 4.7068.
TEST(ThinLayerError, IsLinearInTheInverseSquareOfTheCells)
{
    EXPECT_NEAR(thin_layer_error(4.706787243, 20.0), 0.5 * (-0.093 - 0.037), 1e-9);
}

TEST(ThinLayerError, FallsWithTheSquareOfTheCells)
{
    EXPECT_DOUBLE_EQ(thin_layer_error(16.0, 20.0), -0.019 / 4.0);
    EXPECT_DOUBLE_EQ(thin_layer_error(0.5, 3.0), -0.27);
    EXPECT_DOUBLE_EQ(thin_layer_error(8.0, 1e4), -0.032);
}

}  // namespace
}  // namespace braidzone
