#include "core/error.hpp"
#include "core/wall_tree.hpp"
#include "export/foam_case.hpp"
#include "export/foam_scripts.hpp"
#include "export/foam_surfaces.hpp"
#include "support/braids.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>

namespace braidzone {
namespace {

std::string text_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Sum of the triangles' area vectors of each solid of an ASCII STL.
std::map<std::string, Vec3> solid_areas(const std::string& stl)
{
    std::map<std::string, Vec3> areas;
    std::istringstream words(stl);
    std::string word, solid;
    std::vector<Vec3> corners;
    while (words >> word) {
        if (word == "solid") {
            words >> solid;
            areas[solid] = Vec3::Zero();
        } else if (word == "vertex") {
            Vec3 p;
            words >> p.x() >> p.y() >> p.z();
            corners.push_back(p);
        } else if (word == "endfacet") {
            areas[solid] += 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            corners.clear();
        }
    }
    return areas;
}

/// The number that follows `key` in a dictionary.
double number_after(const std::string& text, const std::string& key)
{
    const auto found = text.find(key);
    if (found == std::string::npos) return std::nan("");
    return std::strtod(text.c_str() + found + key.size(), nullptr);
}

ResistanceSheet sheet_in_tube(double acting)
{
    const auto surface = test::flat_braid(Vec3(-0.5e-3, -0.5e-3, 10e-3), Vec3::UnitX() * 0.1e-3, 10,
                                          Vec3::UnitY() * 0.1e-3, 10, 30e-6);
    ResistanceSheet sheet = make_resistance_sheet(surface, ConstantLaw{{490.0, 330.0}}, Fluid{});
    sheet.acting.assign(sheet.acting.size(), acting);
    return sheet;
}

constexpr double radius = 2e-3, length = 20e-3;

// A closed surface: the area vectors sum to zero. Each end is the 96-sided polygon of radius 2 mm:
// 96 / 2 r^2 sin(2 pi / 96), along the normal out of the lumen.
TEST(VesselStl, IsClosedWithNamedEnds)
{
    const Vessel vessel = test::tube_vessel(radius, length);
    const auto names = patch_names(vessel, 1);
    EXPECT_EQ(names, (std::vector<std::string>{"outlet_1", "inlet"}));
    const auto areas = solid_areas(vessel_stl(vessel, names));
    ASSERT_EQ(areas.size(), 3U);
    EXPECT_LT((areas.at("wall") + areas.at("inlet") + areas.at("outlet_1")).norm(), 1e-18);
    const double end = 48.0 * radius * radius * std::sin(2.0 * std::numbers::pi / 96.0);
    EXPECT_LT((areas.at("inlet") - end * vessel.openings[1].normal).norm(), 1e-14);
}

TEST(ActingDeviceStl, HoldsTheActingPartOnly)
{
    ResistanceSheet sheet = sheet_in_tube(1.0);
    EXPECT_NEAR(solid_areas(acting_device_stl(sheet)).at("device").z(), 1e-6, 1e-18);
    for (std::size_t i = 0; i < 25; ++i)
        sheet.acting[i] = 0.0;
    EXPECT_NEAR(solid_areas(acting_device_stl(sheet)).at("device").z(), 0.75e-6, 1e-18);
    EXPECT_EQ(acting_device_stl(sheet_in_tube(0.0)), "");
}

TEST(WriteFoamCase, StatesFlowFluidAndMesh)
{
    const test::TemporaryFolder folder;
    const Vessel vessel = test::tube_vessel(radius, length);
    const Fluid fluid{1000.0, 4e-3};
    FoamCaseOptions options;
    options.flow.inlet_velocity = 0.3;
    options.inlet = 1;
    write_foam_case(folder.path(), vessel, sheet_in_tube(1.0), fluid, options);

    // Kinematic viscosity 4e-3 / 1000; flow rate 0.3 m/s times the opening's area.
    const std::string transport = text_of(folder.path() / "constant/transportProperties");
    EXPECT_DOUBLE_EQ(number_after(transport, "[0 2 -1 0 0 0 0] "), 4e-6);
    const std::string velocity = text_of(folder.path() / "0/U");
    EXPECT_NEAR(number_after(velocity, "volumetricFlowRate constant "),
                0.3 * vessel.openings[1].area, 1e-15);
    EXPECT_NE(velocity.find("outlet_1"), std::string::npos);

    const std::string snappy = text_of(folder.path() / "system/snappyHexMeshDict");
    const auto at = snappy.find("locationInMesh (");
    ASSERT_NE(at, std::string::npos);
    std::istringstream numbers(snappy.substr(at + 16));
    Vec3 inside;
    numbers >> inside.x() >> inside.y() >> inside.z();
    EXPECT_TRUE(WallTree(vessel).contains(inside));
    // Finest cells 0.45 / 8 mm; the kernel reaches three of them, one more is refined.
    EXPECT_NEAR(number_after(snappy, "device { mode distance; levels (("), 0.225e-3, 1e-12);

    // Before there is a mesh there are no zones, and OpenFOAM must accept that.
    const std::string options_text = text_of(folder.path() / "constant/fvOptions");
    EXPECT_NE(options_text.find("object      fvOptions;"), std::string::npos);
    EXPECT_NE(options_text.find("#include \"fdPorosity\""), std::string::npos);
    EXPECT_EQ(text_of(folder.path() / "constant/fdPorosity").find("explicitPorositySource"),
              std::string::npos);
}

TEST(WriteFoamCase, DeviceOnTheWallIsNotRefined)
{
    const test::TemporaryFolder folder;
    write_foam_case(folder.path(), test::tube_vessel(radius, length), sheet_in_tube(0.0), Fluid{},
                    {});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "constant/triSurface/device.stl"));
    EXPECT_EQ(text_of(folder.path() / "system/snappyHexMeshDict").find("device"),
              std::string::npos);
}

TEST(WriteFoamCase, RefusesOptionsOutOfRange)
{
    const test::TemporaryFolder folder;
    const Vessel vessel = test::tube_vessel(radius, length);
    const auto write = [&](const FoamCaseOptions& options) {
        write_foam_case(folder.path(), vessel, sheet_in_tube(1.0), Fluid{}, options);
    };
    EXPECT_THROW(write({.flow = {.inlet_velocity = 0.0}}), InputError);
    EXPECT_THROW(write({.flow = {.inlet_velocity = std::nan("")}}), InputError);
    EXPECT_THROW(write({.coarse_cell = -1e-3}), InputError);
    EXPECT_THROW(write({.device_refinement = 7}), InputError);
    EXPECT_THROW(write({.inlet = 2}), InputError);
    EXPECT_THROW(write({.flow = {.cycles = 0}}), InputError);
    EXPECT_THROW(write({.flow = {.max_courant = 0.0}}), InputError);
    EXPECT_THROW(write({.flow = {.outlets = OutletShares{{0.5, 0.5}}}}), InputError);
    EXPECT_THROW(write({.flow = {.rheology = CarreauYasuda{.power_index = 2.0}}}), InputError);
}

// The readme says which patch is which: the inlet is the tube's upper end.
TEST(WriteFoamCase, TellsItsOpenings)
{
    const test::TemporaryFolder folder;
    FoamCaseOptions options;
    options.inlet = 1;
    options.flow.outlets = OutletPressures{{250.0}};
    options.flow.rheology = CarreauYasuda{};
    const Vessel vessel = test::tube_vessel(radius, length);
    write_foam_case(folder.path(), vessel, sheet_in_tube(1.0), Fluid{}, options);
    const std::string readme = text_of(folder.path() / "README.md");
    const int inlet_z = vessel.openings[1].centre.z() > 0.5 * length ? 20 : 0;
    EXPECT_NE(readme.find(fmt::format(", {} | inflow, {:.4g} mL/s in", inlet_z,
                                      1e6 * 0.25 * vessel.openings[1].area)),
              std::string::npos)
        << readme;
    EXPECT_NE(readme.find("| pressure 250 Pa |"), std::string::npos);
    EXPECT_NE(readme.find("Carreau-Yasuda"), std::string::npos);
}

// Four times 0.25 s; 20 results of a period, and the first.
TEST(WriteFoamCase, PulsatileCaseRunsItsCycles)
{
    const test::TemporaryFolder folder;
    FoamCaseOptions options;
    options.flow.waveform = FlowWaveform{{}, {0.0, 0.1, 0.25}, {1e-6, 2e-6, 1e-6}};
    options.flow.cycles = 4;
    write_foam_case(folder.path(), test::tube_vessel(radius, length), sheet_in_tube(1.0), Fluid{},
                    options);
    const std::string control = text_of(folder.path() / "system/controlDict");
    EXPECT_NE(control.find("pimpleFoam"), std::string::npos);
    EXPECT_DOUBLE_EQ(number_after(control, "endTime "), 1.0);
    EXPECT_DOUBLE_EQ(number_after(control, "writeInterval "), 0.0125);
    EXPECT_DOUBLE_EQ(number_after(control, "purgeWrite "), 21.0);
    const std::string velocity = text_of(folder.path() / "0/U");
    EXPECT_NE(velocity.find("(0.1 2e-06)"), std::string::npos);
    EXPECT_NE(velocity.find("outOfBounds repeat"), std::string::npos);
    const std::string figures = text_of(folder.path() / "flow_figures");
    EXPECT_DOUBLE_EQ(number_after(figures, "cycle_start="), 0.75);
    EXPECT_DOUBLE_EQ(number_after(figures, "cycle_end="), 1.0);
}

class Allrun : public ::testing::Test {
protected:
    void SetUp() override
    {
        folder_.write("bin/simpleFoam", "#!/bin/sh\n");
        std::filesystem::permissions(folder_.path() / "bin/simpleFoam",
                                     std::filesystem::perms::owner_all);
        folder_.write("Allrun", allrun_script({"/nowhere/it's here", "case.toml"}));
    }
    /// Runs Allrun with a stand-in for OpenFOAM; its messages and exit status.
    std::pair<std::string, int> run(const std::string& environment, const std::string& arguments)
    {
        const std::string folder = folder_.path().string();
        const int status =
            std::system(("env " + environment + " PATH=\"" + folder + "/bin:$PATH\" sh " + folder +
                         "/Allrun " + arguments + " > " + folder + "/out 2>&1")
                            .c_str());
        return {text_of(folder_.path() / "out"), status};
    }
    test::TemporaryFolder folder_;
};

TEST_F(Allrun, SaysThatBraidzoneIsNotFound)
{
    const auto [message, status] = run("-u BRAIDZONE", "");
    EXPECT_NE(status, 0);
    EXPECT_NE(message.find("Braidzone is not found at '/nowhere/it's here'; set BRAIDZONE"),
              std::string::npos)
        << message;
    EXPECT_NE(run("BRAIDZONE=/else/where", "").first.find("not found at '/else/where'"),
              std::string::npos);
}

TEST_F(Allrun, RefusesUnknownArguments)
{
    const auto [message, status] = run("-u BRAIDZONE", "--without");
    EXPECT_NE(status, 0);
    EXPECT_NE(message.find("unknown argument --without; allowed: --without-device, --both, "
                           "--processes N, --continue"),
              std::string::npos);
}

TEST_F(Allrun, RefusesNumbersOfProcessesThatCannotBe)
{
    for (const char* number : {"0", "two", "-1", "1.5", ""}) {
        const auto [message, status] = run("BRAIDZONE=true", std::string("--processes ") + number);
        EXPECT_NE(status, 0);
        EXPECT_NE(message.find(std::string("--processes '") + number + "'; allowed: 1 or more"),
                  std::string::npos)
            << message;
    }
    folder_.write("constant/polyMesh/cellLevel", "");
    folder_.write("fd_export.json",
                  "{\n  \"num_cells\": 2999,\n  \"zones\": [{\n      \"num_cells\": 9\n}]}\n");
    const auto [message, status] = run("BRAIDZONE=true", "--processes 3");
    EXPECT_NE(status, 0);
    EXPECT_NE(message.find("--processes 3 is too many for 2999 cells; allowed: 1 to 2 (1000 cells "
                           "each)"),
              std::string::npos)
        << message;
}

TEST_F(Allrun, ContinuesOnlyWhatWasStopped)
{
    EXPECT_NE(run("BRAIDZONE=true", "--continue").first.find("there is no mesh"),
              std::string::npos);
    folder_.write("constant/polyMesh/cellLevel", "");
    folder_.write("processor0/100/U", "");
    folder_.write("processor1/100/U", "");
    const auto [message, status] = run("BRAIDZONE=true", "--continue");
    EXPECT_NE(status, 0);
    EXPECT_NE(message.find("the stopped run was on 2 processes; add --processes 2"),
              std::string::npos)
        << message;
}

// A mesher that fails: Allrun stops there and shows the end of its log.
TEST_F(Allrun, StopsAtTheFirstFailure)
{
    folder_.write("bin/blockMesh", "#!/bin/sh\necho broken dictionary\nexit 1\n");
    std::filesystem::permissions(folder_.path() / "bin/blockMesh",
                                 std::filesystem::perms::owner_all);
    const auto [message, status] = run("BRAIDZONE=true", "");
    EXPECT_NE(status, 0);
    EXPECT_NE(message.find("broken dictionary"), std::string::npos);
    EXPECT_NE(message.find("blockMesh failed; see "), std::string::npos);
}

}  // namespace
}  // namespace braidzone
