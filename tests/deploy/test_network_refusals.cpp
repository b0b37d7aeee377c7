// What a network of wires does not know it refuses.

#include "core/error.hpp"
#include "deploy/deployment.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {

namespace {

using testing::HasSubstr;

std::string refusal(const ReleaseSchedule& schedule, const DeployOptions& options)
{
    FlowDiverter device = test::pipeline_4x20();
    device.youngs_modulus = 200e9;
    const Vessel vessel = test::tube_vessel(1.85e-3, 12e-3);
    try {
        deploy(device, test::tube_centerline(1.85e-3, 12e-3), WallTree(vessel), 9e-3, schedule,
               options);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "no ConfigError";
}

}  // namespace

TEST(NetworkDeployment, RefusesWhatGoesWithNodesOnRays)
{
    DeployOptions axial{.axial = AxialMotion::free}, hoop{.hoop_migration = true};
    for (DeployOptions options : {axial, hoop}) {
        EXPECT_THAT(refusal({.twists = {{1.0, 5e-3, 2e-3}}}, options),
                    HasSubstr("deployment.twist goes with nodes that stay on their rays only"));
        EXPECT_THAT(refusal({.incomplete_openings = {{DeviceEnd::proximal, 2e-3, 0.2}}}, options),
                    HasSubstr("deployment.incomplete_opening goes with nodes"));
        options.hub_shift = 0.1e-3;
        EXPECT_THAT(refusal({}, options), HasSubstr("deployment.hub_shift = 0.1 mm does not go"));
        options.hub_shift = 0.0;
        options.hub_freedom = 0.5;
        EXPECT_THAT(refusal({}, options),
                    HasSubstr("deployment.hub_freedom = 0.5: with axial = \"free\""));
    }
    EXPECT_THAT(refusal({.sliding = 0.3}, axial),
                HasSubstr("deployment.sliding (1 with release = \"force_free\") prescribes"));
}

}  // namespace braidzone
