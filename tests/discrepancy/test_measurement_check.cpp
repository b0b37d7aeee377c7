#include "core/error.hpp"
#include "discrepancy/measurement_check.hpp"
#include "support/shapes.hpp"
#include "support/straight_device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

using testing::HasSubstr;

/// A device from 0 to 10 mm in a tube of 30 mm.
struct Scene {
    Scene() : lumen(make_lumen()), simulation(make_simulation()) {}

    static Lumen make_lumen()
    {
        Vessel vessel = test::tube_vessel(2e-3, 30e-3);
        WallTree wall(vessel);
        return {std::move(vessel), std::move(wall), test::tube_centerline(2e-3, 30e-3)};
    }
    static Simulation make_simulation()
    {
        Deployment device = test::straight_device(2e-3, 10e-3);
        DeviceSurface surface(device);
        return {std::move(device), std::move(surface)};
    }

    /// The message about points on a cylinder over the device, multiplied and moved.
    std::string refusal(double factor, const Vec3& shift, int count = 400) const
    {
        std::vector<Vec3> points;
        for (int i = 0; i < count; ++i) {
            const double z = 1e-3 + 8e-3 * i / count;
            points.push_back(factor *
                             (Vec3(2e-3 * std::cos(2.4 * i), 2e-3 * std::sin(2.4 * i), z) + shift));
        }
        try {
            require_comparable(points, {}, simulation, lumen);
        } catch (const InputError& error) {
            return error.what();
        }
        return "comparable";
    }

    Lumen lumen;
    Simulation simulation;
};

}  // namespace

TEST(RequireComparable, AcceptsASmallMisplacement)
{
    EXPECT_EQ(Scene().refusal(1.0, Vec3(0.5e-3, 0.3e-3, -0.4e-3)), "comparable");
}

TEST(RequireComparable, SaysWhichUnitWouldFit)
{
    EXPECT_THAT(Scene().refusal(1e-3, Vec3::Zero()),
                HasSubstr("with coordinates 1000 times as large most of them would: the length "
                          "unit is wrong"));
    EXPECT_THAT(Scene().refusal(10.0, Vec3::Zero()), HasSubstr("coordinates 0.1 times as large"));
}

TEST(RequireComparable, SaysWhereTheOtherDeviceLies)
{
    const std::string message = Scene().refusal(1.0, Vec3(0, 0, 18e-3));
    EXPECT_THAT(message, HasSubstr("the measured surface lies from 19 to 26."));
    EXPECT_THAT(message, HasSubstr("the simulated device from 0 to 10 mm; 0 % of the points"));
}

TEST(RequireComparable, SaysHowFarAwayTheScanLies)
{
    const std::string message = Scene().refusal(1.0, Vec3(52e-3, 0, 0));
    EXPECT_THAT(message, HasSubstr("50 mm from the vessel's wall"));
    EXPECT_THAT(message, HasSubstr("register it first"));
}

TEST(RequireComparable, RefusesASpot)
{
    const Scene scene;
    std::vector<Vec3> spot(100, Vec3(2e-3, 0.0, 5e-3));
    spot.front().z() += 1e-3;
    try {
        require_comparable(spot, {}, scene.simulation, scene.lumen);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the measured surface is 1 mm large about (2, 0, 5.01) "
                                            "mm, less than 20 % of the simulated device's 11.49 "
                                            "mm, and no length unit makes it fit"));
    }
}

TEST(RequireComparable, RefusesAFewPoints)
{
    EXPECT_THAT(Scene().refusal(1.0, Vec3::Zero(), 49),
                HasSubstr("the measured surface has 49 points; at least 50 are needed"));
}

}  // namespace braidzone
