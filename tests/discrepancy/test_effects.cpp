#include "core/error.hpp"
#include "discrepancy/effect.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <set>

namespace braidzone {
namespace {

EffectSetting setting()
{
    EffectSetting setting;
    setting.base.device = test::pipeline_4x20();
    setting.base.landing_distal = 25e-3;
    setting.from = 5e-3;
    setting.to = 25e-3;
    setting.middle = Vec3(1e-3, 2e-3, 3e-3);
    return setting;
}

const Effect& effect(const std::string& name)
{
    for (const Effect& one : effect_catalogue()) {
        if (one.name == name) return one;
    }
    throw std::runtime_error(name + " is not in the catalogue");
}

Model with(const std::string& name, const std::vector<double>& values)
{
    return effect(name).apply(setting(), values);
}

}  // namespace

TEST(EffectCatalogue, HasStartsWithinTheBounds)
{
    std::set<std::string> names;
    for (const Effect& one : effect_catalogue()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_FALSE(one.title.empty() || one.separated_by.empty()) << one.name;
        const auto parameters = one.parameters(setting());
        for (const auto& start : one.starts(setting())) {
            ASSERT_EQ(start.size(), parameters.size()) << one.name;
            for (std::size_t i = 0; i < start.size(); ++i) {
                EXPECT_GE(start[i], parameters[i].lower) << one.name;
                EXPECT_LE(start[i], parameters[i].upper) << one.name;
                EXPECT_GT(parameters[i].step, 0.0) << one.name;
            }
        }
    }
    EXPECT_EQ(names.size(), 15u);
}

TEST(Effects, ChangeTheirOwnKeyAndNothingElse)
{
    EXPECT_DOUBLE_EQ(with("nominal_diameter", {0.2e-3}).device.nominal_diameter, 4.2e-3);
    EXPECT_DOUBLE_EQ(with("braid_ratio", {-0.1}).device.braid_ratio, 0.36);
    EXPECT_DOUBLE_EQ(with("landing_offset", {-2e-3}).landing_distal, 23e-3);
    EXPECT_DOUBLE_EQ(with("vessel_offset", {0.05e-3}).wall_offset, 0.05e-3);
    EXPECT_DOUBLE_EQ(with("blooming", {0.1e-3}).imaging.blooming, 0.1e-3);
    // 4.4 kPa over 0.1 mm
    EXPECT_NEAR(with("wall_compliance", {0.1e-3}).options.wall_stiffness, 4.4e7, 1.0);
    EXPECT_EQ(with("wall_compliance", {0.0}).options.wall_stiffness, rigid_wall);
    const Model moved = with("registration", {1e-3, 0.0, 0.0, 0.0, 0.1, 0.0});
    EXPECT_EQ(moved.imaging.pivot, Vec3(1e-3, 2e-3, 3e-3));
    EXPECT_EQ(moved.imaging.shift, Vec3(1e-3, 0.0, 0.0));
    EXPECT_EQ(moved.imaging.rotation, Vec3(0.0, 0.1, 0.0));
    EXPECT_DOUBLE_EQ(moved.device.nominal_diameter, 4e-3);
    EXPECT_DOUBLE_EQ(with("sliding", {0.3, 0.5e-3}).schedule.sliding, 0.3);
    EXPECT_DOUBLE_EQ(with("sliding", {0.3, 0.5e-3}).landing_distal, 25.5e-3);
    EXPECT_DOUBLE_EQ(with("free_hub", {0.1e-3}).options.hub_shift, 0.1e-3);
}

TEST(Effects, ConeAtEitherEnd)
{
    for (const auto& [name, end] : {std::pair{"incomplete_opening_proximal", DeviceEnd::proximal},
                                    {"incomplete_opening_distal", DeviceEnd::distal}}) {
        const auto cones = with(name, {0.2, 3e-3, 0.3, -0.4}).schedule.incomplete_openings;
        ASSERT_EQ(cones.size(), 1u);
        EXPECT_EQ(cones[0].end, end);
        EXPECT_DOUBLE_EQ(cones[0].shrink, 0.2);
        EXPECT_DOUBLE_EQ(cones[0].length, 3e-3);
        EXPECT_DOUBLE_EQ(cones[0].lean, 0.5);
        EXPECT_DOUBLE_EQ(std::tan(cones[0].lean_angle), -4.0 / 3.0);
        EXPECT_GT(std::cos(cones[0].lean_angle), 0.0);
        EXPECT_TRUE(with(name, {0.0, 3e-3, 0.0, 0.0}).schedule.incomplete_openings.empty());
    }
    EffectSetting open = setting();
    open.base.schedule.incomplete_openings = {{DeviceEnd::distal, 2e-3, 0.1}};
    EXPECT_THROW(effect("incomplete_opening_distal").apply(open, {0.2, 3e-3, 0.0, 0.0}),
                 ConfigError);
    EXPECT_EQ(effect("incomplete_opening_proximal")
                  .apply(open, {0.2, 3e-3, 0.0, 0.0})
                  .schedule.incomplete_openings.size(),
              2u);
}

TEST(Effects, TwistOverAStretch)
{
    const auto twists = with("axial_twist", {1.5, 12e-3, 2.5e-3}).schedule.twists;
    ASSERT_EQ(twists.size(), 1u);
    EXPECT_DOUBLE_EQ(twists[0].angle, 1.5);
    EXPECT_DOUBLE_EQ(twists[0].centre, 12e-3);
    EXPECT_DOUBLE_EQ(twists[0].half_width, 2.5e-3);
    EXPECT_TRUE(with("axial_twist", {0.0, 12e-3, 2.5e-3}).schedule.twists.empty());
}

// The vessel over the device as a whole stays where it was, wherever the window is.
TEST(Effects, StraightenTheVesselAroundTheDevice)
{
    const VesselStraightening straightening =
        with("vessel_straightening", {0.4, 12e-3, 6e-3}).straightening;
    EXPECT_DOUBLE_EQ(straightening.share, 0.4);
    EXPECT_DOUBLE_EQ(straightening.centre, 12e-3);
    EXPECT_DOUBLE_EQ(straightening.half_width, 6e-3);
    EXPECT_DOUBLE_EQ(straightening.kept_from, 5e-3);
    EXPECT_DOUBLE_EQ(straightening.kept_to, 25e-3);
    EffectSetting straight = setting();
    straight.base.straightening = straightening;
    EXPECT_THROW(effect("vessel_straightening").apply(straight, {0.1, 12e-3, 6e-3}), ConfigError);
    EXPECT_EQ(
        effect("vessel_straightening").apply(straight, {0.0, 12e-3, 6e-3}).straightening.share,
        0.4);
}

TEST(Effects, PushOverAStretch)
{
    for (const auto& [name, change] : {std::pair{"local_push", -0.5}, {"local_pull", 0.3}}) {
        const Model model = with(name, {change, 15e-3, 2e-3});
        ASSERT_EQ(model.schedule.windows.size(), 1u);
        EXPECT_DOUBLE_EQ(model.schedule.windows[0].from, 13e-3);
        EXPECT_DOUBLE_EQ(model.schedule.windows[0].to, 17e-3);
        EXPECT_DOUBLE_EQ(model.schedule.windows[0].spacing, 1.0 + change);
    }
    EXPECT_TRUE(with("local_push", {0.0, 15e-3, 2e-3}).schedule.windows.empty());
}

// The starts of a push lie all along the device, none of them beyond its ends.
TEST(Effects, StartAPushAllAlongTheDevice)
{
    const auto starts = effect("local_push").starts(setting());
    EXPECT_EQ(starts.size(), 14u);  // at two changes of the spacing
    EXPECT_DOUBLE_EQ(starts.front()[1], 7e-3);
    EXPECT_DOUBLE_EQ(starts.back()[1], 23e-3);
}

TEST(Effects, RefuseAPushWhereOneStands)
{
    EffectSetting pushed = setting();
    pushed.base.schedule.windows = {{14e-3, 16e-3, 0.5}};
    EXPECT_THROW(effect("local_push").apply(pushed, {-0.5, 15e-3, 2e-3}), ConfigError);
    EXPECT_EQ(effect("local_push").apply(pushed, {-0.5, 20e-3, 2e-3}).schedule.windows.size(), 2u);
}

TEST(Effects, AddToTheComplianceOfTheCase)
{
    EffectSetting soft = setting();
    soft.base.options.wall_stiffness = 4.4e7;
    EXPECT_NEAR(effect("wall_compliance").apply(soft, {0.1e-3}).options.wall_stiffness, 2.2e7, 1.0);
}

}  // namespace braidzone
