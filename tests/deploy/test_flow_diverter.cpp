#include "core/error.hpp"
#include "deploy/flow_diverter.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace braidzone {
namespace {

FlowDiverter sound_device()
{
    FlowDiverter device;
    device.nominal_diameter = 4e-3;
    device.nominal_length = 20e-3;
    device.braid_ratio = 0.4;
    device.surface_coefficient = 0.6;
    device.radial_coefficient = 0.1;
    device.reference_node_area = 2.9e-7;
    return device;
}

TEST(FlowDiverter, AcceptsABraid)
{
    EXPECT_FALSE(find_invalid(sound_device()).has_value());
    EXPECT_NO_THROW(validate(sound_device()));
    EXPECT_EQ(sound_device().nominal_radius(), 2e-3);
}

struct Change {
    std::string key;
    std::function<void(FlowDiverter&)> apply;
    std::string finding;
};

TEST(FlowDiverter, RefusesWhatIsNoBraidAndSaysWhy)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Change> changes = {
        {"num_wires", [](FlowDiverter& d) { d.num_wires = 47; },
         "= 47 is not an even number of 8 or more"},
        {"num_wires", [](FlowDiverter& d) { d.num_wires = 6; },
         "= 6 is not an even number of 8 or more"},
        {"wire_diameter", [](FlowDiverter& d) { d.wire_diameter = 0.0; }, "= 0 m is not positive"},
        {"wire_diameter", [nan](FlowDiverter& d) { d.wire_diameter = nan; },
         "= nan m is not positive"},
        {"diameter", [](FlowDiverter& d) { d.nominal_diameter = -4e-3; },
         "= -0.004 m is not positive"},
        {"length", [](FlowDiverter& d) { d.nominal_length = 0.0; }, "= 0 m is not positive"},
        {"catheter_diameter", [](FlowDiverter& d) { d.catheter_diameter = 0.0; },
         "= 0 m is not positive"},
        {"surface_coefficient", [](FlowDiverter& d) { d.surface_coefficient = 0.0; },
         "= 0 N/m is not positive"},
        {"radial_coefficient", [](FlowDiverter& d) { d.radial_coefficient = -1.0; },
         "= -1 N/m is not positive"},
        {"reference_node_area", [](FlowDiverter& d) { d.reference_node_area = 0.0; },
         "= 0 m^2 is not positive"},
        {"braid_ratio", [nan](FlowDiverter& d) { d.braid_ratio = nan; }, "= nan is not positive"},
        {"force_scale", [](FlowDiverter& d) { d.force_scale = 0.0; }, "= 0 is not positive"},
        {"wire_diameter", [](FlowDiverter& d) { d.wire_diameter = 1.2e-3; },
         "= 1200 um exceeds device.diameter / 10 = 400 um"},
        // 24 helices on pi 4 mm are 523.599 um apart around, times 0.4 / sqrt(1.16) = 194.46 um.
        {"wire_diameter", [](FlowDiverter& d) { d.wire_diameter = 0.2e-3; },
         "= 200 um leaves no pores: neighbours of 48 wires at braid_ratio 0.4 are 194.46 um "
         "apart"},
        {"catheter_diameter", [](FlowDiverter& d) { d.catheter_diameter = 4e-3; },
         "= 4 mm is not narrower than device.diameter = 4 mm"},
    };
    for (const Change& change : changes) {
        FlowDiverter device = sound_device();
        change.apply(device);
        const auto invalid = find_invalid(device);
        ASSERT_TRUE(invalid.has_value()) << change.key << " " << change.finding;
        EXPECT_EQ(invalid->key, change.key);
        EXPECT_EQ(invalid->finding, change.finding);
        try {
            validate(device);
            FAIL() << change.key << " was accepted";
        } catch (const ConfigError& error) {
            EXPECT_EQ(std::string(error.what()), "device." + change.key + " " + change.finding);
        }
    }
}

}  // namespace
}  // namespace braidzone
