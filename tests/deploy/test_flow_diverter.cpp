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

FlowDiverter wire_device()
{
    FlowDiverter device = sound_device();
    device.surface_coefficient = device.radial_coefficient = device.reference_node_area = 0.0;
    device.forces = ForceSource::wire_theory;
    device.youngs_modulus = 200e9;
    return device;
}

TEST(FlowDiverter, NeedsNoSpringsWithWireTheory)
{
    EXPECT_FALSE(find_invalid(wire_device()).has_value());
}

TEST(FlowDiverter, RefusesWiresWithoutModuli)
{
    const auto finding = [](double modulus, double poisson_ratio) {
        FlowDiverter device = wire_device();
        device.youngs_modulus = modulus;
        device.poisson_ratio = poisson_ratio;
        const auto invalid = find_invalid(device);
        return invalid ? invalid->key + " " + invalid->finding : "accepted";
    };
    EXPECT_EQ(finding(0.0, 0.3), "youngs_modulus = 0 Pa is not positive");
    EXPECT_EQ(finding(200e9, 0.6), "poisson_ratio = 0.6 is out of range; allowed are 0 to 0.5");
    EXPECT_EQ(finding(200e9, std::numeric_limits<double>::quiet_NaN()),
              "poisson_ratio = nan is out of range; allowed are 0 to 0.5");
}

// Widest: 2 mm (sqrt(1.16) - 1) = 0.154066 mm; narrowest: the catheter's 0.345 mm less 2 mm.
TEST(FlowDiverter, RefusesAFlareBeyondTheBraid)
{
    FlowDiverter device = sound_device();
    device.distal_flare = 0.15e-3;
    device.proximal_flare = -1.6e-3;
    EXPECT_FALSE(find_invalid(device).has_value());
    device.distal_flare = 0.16e-3;
    auto invalid = find_invalid(device);
    ASSERT_TRUE(invalid.has_value());
    EXPECT_EQ(invalid->key, "distal_flare");
    EXPECT_EQ(invalid->finding,
              "= 0.16 mm is out of range; a braid of radius 2 mm and ratio 0.4 allows -1.655 to "
              "0.154066 mm");
    device.distal_flare = 0.0;
    device.proximal_flare = -1.7e-3;
    invalid = find_invalid(device);
    ASSERT_TRUE(invalid.has_value());
    EXPECT_EQ(invalid->key, "proximal_flare");
    device.proximal_flare = 0.0;
    device.flare_length = 0.0;
    invalid = find_invalid(device);
    ASSERT_TRUE(invalid.has_value());
    EXPECT_EQ(invalid->key + " " + invalid->finding, "flare_length = 0 m is not positive");
}

// 48 wires of 30 um along the axis of 4 mm cover f = 0.0572958 with one family each.
TEST(BraidRatioAtPorosity, RefusesWhatNoAngleGives)
{
    const auto message = [](double porosity) -> std::string {
        try {
            braid_ratio_at_porosity(sound_device(), porosity);
        } catch (const ConfigError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(
        message(0.9),
        "nominal_porosity = 0.9 is too large: 48 wires of 30 um leave less than 0.888691 of a "
        "device of 4 mm open");
    EXPECT_EQ(message(1.0), "nominal_porosity = 1 is out of range; it must lie between 0 and 1");
    EXPECT_EQ(message(0.0), "nominal_porosity = 0 is out of range; it must lie between 0 and 1");
    EXPECT_EQ(message(0.88), "accepted");
}

TEST(ForceOrigin, NamesTheSourceAndItsFigures)
{
    FlowDiverter device = sound_device();
    device.force_scale = 61.0;
    EXPECT_EQ(force_origin(device),
              "spring coefficients of 0.6 N/m (surface) and 0.1 N/m (radial, a node of 0.29 mm^2), "
              "force scale 61");
    EXPECT_EQ(
        force_origin(wire_device()),
        "wire theory (Jedwab and Clerc 1993): 48 wires of 30 um, E = 200 GPa, Poisson's ratio "
        "0.3");
}

}  // namespace
}  // namespace braidzone
