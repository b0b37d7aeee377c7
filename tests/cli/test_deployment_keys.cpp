#include "cli/deployment_keys.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace braidzone
