#include "cli/deployment_keys.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace braidzone {

namespace {

using testing::HasSubstr;

DeploymentKeys read(const std::string& keys)
{
    const test::TemporaryFolder folder;
    const TomlTable root = TomlTable::read_file(
        folder.write("case.toml", "[deployment]\nlanding_distal = \"18 mm\"\n" + keys));
    DeploymentKeys deployment = read_deployment_keys(root.table("deployment"));
    root.finish();
    return deployment;
}

std::string refusal(const std::string& keys)
{
    try {
        read(keys);
    } catch (const ConfigError& error) {
        return error.what();
    }
    return "no ConfigError";
}

}  // namespace

TEST(DeploymentKeys, AreThePaperWithCrossingsByDefault)
{
    const DeploymentKeys keys = read("");
    EXPECT_EQ(std::get<double>(keys.landing_distal), 18e-3);
    EXPECT_EQ(keys.options.lattice, LatticeKind::crossings);
    EXPECT_EQ(keys.options.axial, AxialMotion::locked);
    EXPECT_EQ(keys.options.release_order, ReleaseOrder::ring_by_ring);
    EXPECT_EQ(keys.options.motion, Motion::inertial);
    EXPECT_EQ(keys.options.hub_freedom, 0.0);
    EXPECT_FALSE(keys.options.hoop_migration);
    EXPECT_EQ(keys.options.friction, infinite_friction);
    EXPECT_EQ(keys.options.wall_stiffness, rigid_wall);
    EXPECT_EQ(keys.options.num_frames, 0);
}

TEST(DeploymentKeys, NameEveryEffect)
{
    const DeployOptions options = read(R"(lattice = "paper-2020"
axial = "free"
release_order = "at_once"
motion = "quasi_static"
ring_hub = "free"
hoop_migration = true
friction = 0.2
wall_stiffness = "100 kPa/mm"
num_frames = 12
)")
                                      .options;
    EXPECT_EQ(options.lattice, LatticeKind::paper_2020);
    EXPECT_EQ(options.axial, AxialMotion::free);
    EXPECT_EQ(options.release_order, ReleaseOrder::at_once);
    EXPECT_EQ(options.motion, Motion::quasi_static);
    EXPECT_EQ(options.hub_freedom, 1.0);
    EXPECT_TRUE(options.hoop_migration);
    EXPECT_EQ(options.friction, 0.2);
    EXPECT_DOUBLE_EQ(options.wall_stiffness, 1e8);
    EXPECT_EQ(options.num_frames, 12);
}

TEST(DeploymentKeys, TakeFrictionAsANameOrANumber)
{
    const std::string slides = "hoop_migration = true\n";
    EXPECT_EQ(read("friction = \"infinite\"\n").options.friction, infinite_friction);
    EXPECT_EQ(read(slides + "friction = \"none\"\n").options.friction, 0.0);
    EXPECT_EQ(read(slides + "friction = 1\n").options.friction, 1.0);
}

TEST(DeploymentKeys, RefuseFrictionWhereNothingSlides)
{
    EXPECT_THAT(refusal("friction = 0.1\n"),
                HasSubstr("case.toml:3: deployment.friction = 0.1 has no effect"));
    EXPECT_THAT(refusal("friction = \"none\"\n"), HasSubstr("deployment.axial = \"free\""));
}

TEST(DeploymentKeys, RefuseWhatIsOutOfRange)
{
    EXPECT_THAT(refusal("axial = \"free\"\nfriction = -0.1\n"),
                HasSubstr("deployment.friction = -0.1 is negative"));
    EXPECT_THAT(refusal("axial = \"free\"\nfriction = \"nome\"\n"),
                HasSubstr("deployment.friction = \"nome\" is not known"));
    EXPECT_THAT(refusal("wall_stiffness = \"0 Pa/m\"\n"), HasSubstr("it must be positive"));
    EXPECT_THAT(refusal("wall_stiffness = \"1 Pa\"\n"), HasSubstr("pressure over displacement"));
    EXPECT_THAT(refusal("num_frames = -1\n"), HasSubstr("allowed are 0 to 10000"));
}

TEST(DeploymentKeys, SuggestTheNameThatWasMeant)
{
    EXPECT_THAT(refusal("lattice = \"paper-2002\"\n"), HasSubstr("did you mean \"paper-2020\""));
    EXPECT_THAT(refusal("motion = \"quasistatic\"\n"), HasSubstr("quasi_static"));
    EXPECT_THAT(refusal("release_order = \"at_one\"\n"), HasSubstr("at_once"));
    EXPECT_THAT(refusal("ring_hub = \"fre\"\n"), HasSubstr("free"));
    EXPECT_THAT(refusal("axial = \"loked\"\n"), HasSubstr("locked"));
}

TEST(DeploymentKeys, NameTheShareOfASwitchOrAnEndOfIt)
{
    EXPECT_EQ(read("hub_freedom = 0.3\n").options.hub_freedom, 0.3);
    EXPECT_EQ(read("ring_hub = \"free\"\n").options.hub_freedom, 1.0);
    EXPECT_EQ(read("hub_shift = \"0.1 mm\"\n").options.hub_shift, 0.1e-3);
    EXPECT_EQ(read("sliding = 0.25\n").schedule.sliding, 0.25);
    EXPECT_THAT(refusal("sliding = 1.5\n"),
                HasSubstr("deployment.sliding = 1.5 is out of range; allowed are 0 (nominal) to 1 "
                          "(force_free)"));
    EXPECT_THAT(refusal("hub_freedom = -0.1\n"), HasSubstr("allowed are 0 (fixed) to 1 (free)"));
    EXPECT_THAT(refusal("sliding = 0.5\nrelease = \"nominal\"\n"),
                HasSubstr("deployment.sliding = 0.5 stands beside release"));
}

TEST(DeploymentKeys, ReadTwistsAndIncompleteOpenings)
{
    const ReleaseSchedule schedule = read(R"([[deployment.twist]]
angle = "90 deg"
centre = "12 mm"
half_width = "2.5 mm"
[[deployment.incomplete_opening]]
length = "3 mm"
shrink = 0.2
[[deployment.incomplete_opening]]
end = "distal"
length = "2 mm"
shrink = 0.1
lean = 0.5
lean_angle = "90 deg"
)")
                                         .schedule;
    ASSERT_EQ(schedule.twists.size(), 1u);
    EXPECT_DOUBLE_EQ(schedule.twists[0].angle, 0.5 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(schedule.twists[0].centre, 12e-3);
    EXPECT_DOUBLE_EQ(schedule.twists[0].half_width, 2.5e-3);
    ASSERT_EQ(schedule.incomplete_openings.size(), 2u);
    EXPECT_EQ(schedule.incomplete_openings[0].end, DeviceEnd::proximal);
    EXPECT_DOUBLE_EQ(schedule.incomplete_openings[0].length, 3e-3);
    EXPECT_EQ(schedule.incomplete_openings[1].end, DeviceEnd::distal);
    EXPECT_EQ(schedule.incomplete_openings[1].shrink, 0.1);
    EXPECT_EQ(schedule.incomplete_openings[0].lean, 0.0);
    EXPECT_EQ(schedule.incomplete_openings[1].lean, 0.5);
    EXPECT_DOUBLE_EQ(schedule.incomplete_openings[1].lean_angle, 0.5 * std::numbers::pi);
}

TEST(DeploymentKeys, RefuseTwistsAndIncompleteOpeningsThatCannotBe)
{
    EXPECT_THAT(refusal("[[deployment.twist]]\nangle = \"90 deg\"\ncentre = \"12 mm\"\n"
                        "half_width = \"0 mm\"\n"),
                HasSubstr("deployment.twist: twist: half_width = 0 mm; it must be positive"));
    EXPECT_THAT(refusal("[[deployment.incomplete_opening]]\nlength = \"3 mm\"\nshrink = 1.2\n"),
                HasSubstr("deployment.incomplete_opening: incomplete_opening: shrink = 1.2"));
    EXPECT_THAT(refusal("[[deployment.incomplete_opening]]\nend = \"distl\"\nlength = \"3 mm\"\n"
                        "shrink = 0.2\n"),
                HasSubstr("did you mean \"distal\""));
}

TEST(DeploymentKeys, TakeNoMotionWhereNothingNeedsOne)
{
    EXPECT_EQ(read("motion = \"none\"\n").options.motion, Motion::none);
    EXPECT_EQ(name_of(Motion::none), "none");
    EXPECT_THAT(refusal("motion = \"none\"\nhub_freedom = 0.5\n"),
                HasSubstr("\"none\" and hub_freedom = 0.5 exclude each other"));
    EXPECT_THAT(refusal("motion = \"none\"\nnum_frames = 5\n"),
                HasSubstr("leaves no shapes on the way for num_frames = 5"));
    EXPECT_THAT(refusal("motion = \"non\"\n"), HasSubstr("did you mean \"none\""));
}

}  // namespace braidzone
