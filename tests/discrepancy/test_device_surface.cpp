#include "discrepancy/device_surface.hpp"
#include "support/straight_device.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace braidzone {

// A point at radius R + d over a cylinder of crossings lies d outside it, but for the sagitta of
// the rhombi, R (1 - cos(pi / n)) = 17 um for 24 crossings of 2 mm.
TEST(DeviceSurface, MeasuresSignedDistanceToACylinder)
{
    const Deployment device = test::straight_device(2e-3, 10e-3);
    const DeviceSurface surface(device);
    const double sagitta = 2e-3 * (1.0 - std::cos(std::numbers::pi / 24));
    for (const double distance : {-0.3e-3, -0.05e-3, 0.05e-3, 0.4e-3}) {
        for (const double angle : {0.1, 1.7, 3.0, -2.2}) {
            const double r = 2e-3 + distance;
            const SurfaceFoot foot =
                surface.nearest({r * std::cos(angle), r * std::sin(angle), 5.1e-3});
            EXPECT_GE(foot.distance, distance - 1e-9);
            EXPECT_LE(foot.distance, distance + sagitta + 1e-9);
            EXPECT_NEAR(foot.arc_length, 5.1e-3, 1e-4);  // half a ring spacing: rhombi are flat
            EXPECT_NEAR(std::remainder(foot.angle - angle, 2.0 * std::numbers::pi), 0.0, 0.02);
            EXPECT_NEAR(foot.normal.dot(Vec3(std::cos(angle), std::sin(angle), 0.0)), 1.0, 1e-2);
            EXPECT_FALSE(foot.is_on_rim);
        }
    }
}

TEST(DeviceSurface, KnowsItsRims)
{
    const DeviceSurface surface(test::straight_device(2e-3, 10e-3));
    EXPECT_TRUE(surface.nearest({2e-3, 0.0, 11e-3}).is_on_rim);
    EXPECT_TRUE(surface.nearest({2e-3, 0.0, -1e-3}).is_on_rim);
    EXPECT_FALSE(surface.nearest({2e-3, 0.0, 9e-3}).is_on_rim);
}

}  // namespace braidzone
