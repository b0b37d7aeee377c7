#include "discrepancy/fingerprint.hpp"

#include <gtest/gtest.h>

namespace braidzone {

// F = (2, 0), z = (1, 5): c = 2 / 4, and what is left is (0, 5), 1 less in the sum of squares.
TEST(FingerprintGain, IsWhatTheBestSizeTakesOff)
{
    const FingerprintGain best =
        fingerprint_gain(Eigen::Vector2d(2.0, 0.0), Eigen::Vector2d(1.0, 5.0));
    EXPECT_DOUBLE_EQ(best.size, 0.5);
    EXPECT_DOUBLE_EQ(best.gain, 0.5);
}

// z = 4 F, at no more than 2 F: (8^2 - 4^2) / 2.
TEST(FingerprintGain, GoesNoFurtherThanTwiceTheSize)
{
    const FingerprintGain best =
        fingerprint_gain(Eigen::Vector2d(2.0, 0.0), Eigen::Vector2d(8.0, 0.0));
    EXPECT_DOUBLE_EQ(best.size, 2.0);
    EXPECT_DOUBLE_EQ(best.gain, 24.0);
}

TEST(FingerprintGain, IsNoneTheOtherWayOrWithoutAFingerprint)
{
    EXPECT_EQ(fingerprint_gain(Eigen::Vector2d(2.0, 0.0), Eigen::Vector2d(-1.0, 5.0)).gain, 0.0);
    EXPECT_EQ(fingerprint_gain(Eigen::Vector2d::Zero(), Eigen::Vector2d(1.0, 5.0)).gain, 0.0);
}

}  // namespace braidzone
