#include "export/colour_map.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

double lightness(const Colour& colour)
{
    return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
}

// Ends of the map as published: #440154 and #fde725.
TEST(Viridis, HasThePublishedEnds)
{
    EXPECT_NEAR(viridis(0.0)[0], 0x44 / 255.0, 1e-12);
    EXPECT_NEAR(viridis(0.0)[1], 0x01 / 255.0, 1e-12);
    EXPECT_NEAR(viridis(0.0)[2], 0x54 / 255.0, 1e-12);
    EXPECT_NEAR(viridis(1.0)[0], 0xfd / 255.0, 1e-12);
    EXPECT_NEAR(viridis(1.0)[2], 0x25 / 255.0, 1e-12);
    EXPECT_EQ(viridis(-1.0), viridis(0.0));
    EXPECT_EQ(viridis(2.0), viridis(1.0));
}

TEST(Viridis, GetsLighterAllTheWay)
{
    for (int i = 0; i < 100; ++i) {
        EXPECT_LT(lightness(viridis(i / 100.0)), lightness(viridis((i + 1) / 100.0))) << i;
    }
}

}  // namespace
}  // namespace braidzone
