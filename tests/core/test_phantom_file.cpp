#include "core/error.hpp"
#include "core/phantom_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

namespace braidzone {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

const std::string vessel = "[vessel]\nproximal_radius = \"2 mm\"\n[[segment]]\nlength = \"9 mm\"\n";

Phantom read(const std::string& text)
{
    const std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) /
        (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".toml");
    std::ofstream(path) << text;
    return read_phantom(TomlTable::read_file(path));
}

TEST(ReadPhantom, ReadsEveryKey)
{
    const Phantom phantom = read(R"(
[vessel]
proximal_radius = "1.95 mm"
distal_radius = "1.8 mm"
ovality = 0.8
oval_direction = "30 deg"
edge_length = "350 um"
blend_radius = "0.2 mm"
[[segment]]
length = "1 cm"
[[segment]]
length = "5 mm"
angle = "60 deg"
plane_angle = "90 deg"
[[sac]]
position = "4 mm"
direction = "180 deg"
diameter = "7 mm"
height = "8 mm"
neck = "4.5 mm"
edge_length = "0.8 mm"
[[branch]]
position = "2 mm"
direction = "30 deg"
tilt = "70 deg"
radius = "0.8 mm"
length = "6 mm"
[bifurcation]
radius = "1.4 mm"
length = "10 mm"
half_angle = "40 deg"
)");
    EXPECT_DOUBLE_EQ(phantom.proximal_radius, 1.95e-3);
    EXPECT_DOUBLE_EQ(phantom.distal_radius, 1.8e-3);
    EXPECT_DOUBLE_EQ(phantom.ovality, 0.8);
    EXPECT_DOUBLE_EQ(phantom.oval_direction, 30.0 * degree);
    EXPECT_DOUBLE_EQ(phantom.edge_length, 0.35e-3);
    EXPECT_DOUBLE_EQ(phantom.blend_radius, 0.2e-3);
    ASSERT_EQ(phantom.segments.size(), 2u);
    EXPECT_DOUBLE_EQ(phantom.segments[0].length, 10e-3);
    EXPECT_DOUBLE_EQ(phantom.segments[0].angle, 0.0);
    EXPECT_DOUBLE_EQ(phantom.segments[1].length, 5e-3);
    EXPECT_DOUBLE_EQ(phantom.segments[1].angle, 60.0 * degree);
    EXPECT_DOUBLE_EQ(phantom.segments[1].plane_angle, 90.0 * degree);
    ASSERT_EQ(phantom.sacs.size(), 1u);
    EXPECT_DOUBLE_EQ(phantom.sacs[0].position.value(), 4e-3);
    EXPECT_DOUBLE_EQ(phantom.sacs[0].direction, 180.0 * degree);
    EXPECT_DOUBLE_EQ(phantom.sacs[0].diameter, 7e-3);
    EXPECT_DOUBLE_EQ(phantom.sacs[0].height, 8e-3);
    EXPECT_DOUBLE_EQ(phantom.sacs[0].neck, 4.5e-3);
    EXPECT_DOUBLE_EQ(phantom.sacs[0].edge_length, 0.8e-3);
    ASSERT_EQ(phantom.branches.size(), 1u);
    EXPECT_DOUBLE_EQ(phantom.branches[0].position, 2e-3);
    EXPECT_DOUBLE_EQ(phantom.branches[0].direction, 30.0 * degree);
    EXPECT_DOUBLE_EQ(phantom.branches[0].tilt, 70.0 * degree);
    EXPECT_DOUBLE_EQ(phantom.branches[0].radius, 0.8e-3);
    EXPECT_DOUBLE_EQ(phantom.branches[0].length, 6e-3);
    ASSERT_TRUE(phantom.bifurcation);
    EXPECT_DOUBLE_EQ(phantom.bifurcation->radius, 1.4e-3);
    EXPECT_DOUBLE_EQ(phantom.bifurcation->length, 10e-3);
    EXPECT_DOUBLE_EQ(phantom.bifurcation->half_angle, 40.0 * degree);
}

TEST(ReadPhantom, DefaultsFollowWhatIsGiven)
{
    const Phantom phantom = read(vessel + "[[sac]]\ndiameter = \"6 mm\"\nneck = \"3 mm\"\n");
    EXPECT_DOUBLE_EQ(phantom.distal_radius, 2e-3);
    EXPECT_DOUBLE_EQ(phantom.edge_length, Phantom{}.edge_length);
    EXPECT_DOUBLE_EQ(phantom.sacs.at(0).height, 6e-3);
    EXPECT_FALSE(phantom.sacs.at(0).position);
    EXPECT_FALSE(phantom.bifurcation);
}

void expect_refused(const std::string& text, const std::string& words)
{
    try {
        read(text);
        FAIL() << "not refused: " << words;
    } catch (const ConfigError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(ReadPhantom, IsStrict)
{
    expect_refused("[[segment]]\nlength = \"9 mm\"\n", "vessel");
    expect_refused("[vessel]\nproximal_radius = 2.0\n", "proximal_radius");
    expect_refused("[vessel]\nproximal_radius = \"2 mm/s\"\n", "proximal_radius");
    expect_refused("[vessel]\nedge_length = \"0.4 mm\"\n", "proximal_radius");
    expect_refused(vessel + "angel = \"30 deg\"\n", "angle");
    expect_refused(vessel + "angle = \"3 mm\"\n", "angle");
    expect_refused(vessel + "[[sack]]\nneck = \"3 mm\"\n", "sack");
    expect_refused(vessel + "[[sac]]\ndiameter = \"6 mm\"\n", "neck");
}

}  // namespace
}  // namespace braidzone
