#include "core/error.hpp"
#include "export/foam_cell_zones.hpp"
#include "export/foam_zones.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>

namespace braidzone {
namespace {

std::string text_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Resistance on every cell of a row of cubes along x: D = 1e8 exp(-i / 40), normals that turn in
/// the x-y plane from 0 to 90 degrees, with every other one reversed.
CellResistance varied_resistance(const FoamMesh& mesh, double tangential_ratio)
{
    CellResistance resistance;
    resistance.tangential_ratio = {tangential_ratio, tangential_ratio};
    const int num_cells = mesh.num_cells();
    for (int i = 0; i < num_cells; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / num_cells;
        resistance.cells.push_back(i);
        resistance.darcy.push_back(1e8 * std::exp(-i / 40.0));
        resistance.forchheimer.push_back(3e3 * std::exp(-i / 40.0));
        resistance.normal.push_back((i % 2 == 0 ? 1.0 : -1.0) *
                                    Vec3(std::cos(angle), std::sin(angle), 0.0));
    }
    return resistance;
}

TEST(Cluster, KeepsTheIntegralAndEveryCellOnce)
{
    const FoamMesh mesh = test::foam_box({200, 1, 1}, 1e-4);
    const CellResistance resistance = varied_resistance(mesh, 0.1);
    for (const int most : {1, 7, 64}) {
        const auto zones = cluster(resistance, mesh, most);
        EXPECT_EQ(zones.size(), static_cast<std::size_t>(most));
        EXPECT_NEAR(resistance_integral(zones) / resistance_integral(resistance, mesh), 1.0, 1e-13);
        std::set<int> cells;
        double volume = 0.0;
        for (const FoamZone& zone : zones) {
            EXPECT_TRUE(std::is_sorted(zone.cells.begin(), zone.cells.end()));
            cells.insert(zone.cells.begin(), zone.cells.end());
            volume += zone.volume;
        }
        EXPECT_EQ(cells.size(), 200U);
        EXPECT_NEAR(volume, 200e-12, 1e-24);
    }
}

TEST(Cluster, MoreZonesFollowTheResistanceMoreClosely)
{
    const FoamMesh mesh = test::foam_box({200, 1, 1}, 1e-4);
    const CellResistance resistance = varied_resistance(mesh, 0.1);
    const auto mean_error = [&](int most) {
        double sum = 0.0;
        for (const FoamZone& zone : cluster(resistance, mesh, most))
            for (const int cell : zone.cells) {
                const auto i = static_cast<std::size_t>(cell);
                const double turned = 1.0 - std::abs(zone.normal.dot(resistance.normal[i]));
                sum += std::abs(std::log(zone.darcy / resistance.darcy[i])) + turned;
            }
        return sum / 200.0;
    };
    // Bins of one quantity halve their error when their number doubles; two quantities share them.
    EXPECT_LT(mean_error(16), 0.6 * mean_error(4));
    EXPECT_LT(mean_error(64), 0.6 * mean_error(16));
    EXPECT_LT(mean_error(64), 0.05);
}

TEST(Cluster, OppositeNormalsAreOneDirection)
{
    const FoamMesh mesh = test::foam_box({4, 1, 1}, 1e-4);
    CellResistance resistance;
    resistance.tangential_ratio = {0.0, 0.0};
    resistance.cells = {0, 1, 2, 3};
    resistance.darcy = {1e8, 1e8, 1e8, 1e8};
    resistance.forchheimer = {0, 0, 0, 0};
    resistance.normal = {Vec3::UnitX(), Vec3(-Vec3::UnitX()), Vec3::UnitY(), Vec3(-Vec3::UnitY())};
    const auto zones = cluster(resistance, mesh, 64);
    ASSERT_EQ(zones.size(), 2U);
    for (const FoamZone& zone : zones) {
        EXPECT_EQ(zone.cells.size(), 2U);
        const Vec3& member = resistance.normal[static_cast<std::size_t>(zone.cells[0])];
        EXPECT_NEAR(std::abs(zone.normal.dot(member)), 1.0, 1e-12);
    }
}

// Isotropic resistance: the normal has no effect, and cells of equal strength are one zone.
TEST(Cluster, IsotropicResistanceIgnoresNormals)
{
    const FoamMesh mesh = test::foam_box({50, 1, 1}, 1e-4);
    CellResistance resistance = varied_resistance(mesh, 1.0);
    for (double& darcy : resistance.darcy)
        darcy = 2e8;
    EXPECT_EQ(cluster(resistance, mesh, 64).size(), 1U);
}

TEST(Cluster, WithoutResistanceThereIsNoZone)
{
    const FoamMesh mesh = test::foam_box({2, 1, 1}, 1e-4);
    EXPECT_TRUE(cluster(CellResistance{}, mesh).empty());
    EXPECT_THROW(cluster(CellResistance{}, mesh, 0), InputError);
}

TEST(PorousSources, StatesTensorAlongTheZonesAxes)
{
    FoamZone zone;
    zone.darcy = 4e8;
    zone.forchheimer = 5e3;
    zone.normal = Vec3::UnitZ();
    const std::string text = porous_sources({zone}, {0.25, 0.1}, "fvOptions");
    EXPECT_NE(text.find("cellZone        FD_0000;"), std::string::npos);
    EXPECT_NE(text.find("d [0 -2 0 0 0 0 0] (400000000 100000000 100000000);"), std::string::npos);
    EXPECT_NE(text.find("f [0 -1 0 0 0 0 0] (5000 500 500);"), std::string::npos);
    EXPECT_NE(text.find("e1              (0 0 1);"), std::string::npos);
}

// nu D = 4e-6 m^2/s times D, and half of F.
TEST(PorousSources, KeepAViscosityWithFixedCoefficients)
{
    FoamZone zone;
    zone.darcy = 4e8;
    zone.forchheimer = 5e3;
    const std::string text = porous_sources({zone}, {0.25, 0.1}, "fvOptions", Fluid{1000.0, 4e-3});
    EXPECT_EQ(text.find("DarcyForchheimer"), std::string::npos);
    EXPECT_NE(text.find("fixedCoeff;"), std::string::npos);
    EXPECT_NE(text.find("alpha [0 0 -1 0 0 0 0] (1600 400 400);"), std::string::npos) << text;
    EXPECT_NE(text.find("beta [0 -1 0 0 0 0 0] (2500 250 250);"), std::string::npos) << text;
}

TEST(WriteFoamZones, KeepsOtherZonesAndReplacesItsOwn)
{
    const test::TemporaryFolder folder;
    // As OpenFOAM writes it in binary: the labels are raw, the rest is text.
    const std::vector<std::int32_t> labels{40, 41};
    std::string raw(8, '\0');
    std::memcpy(raw.data(), labels.data(), raw.size());
    folder.write("constant/polyMesh/cellZones",
                 "FoamFile { version 2.0; format binary; class regIOobject; arch "
                 "\"LSB;label=32;scalar=64\"; }\n2\n(\nrotor\n{\ntype cellZone;\ncellLabels      "
                 "List<label> \n2\n(" +
                     raw +
                     ");\n}\n\nFD_0007\n{\ntype cellZone;\ncellLabels List<label> 0;\n}\n)\n");
    FoamZone zone;
    zone.cells = {3, 5};
    zone.darcy = 1e8;
    write_foam_zones(folder.path(), {zone}, {});

    const auto zones = read_cell_zones(folder.path());
    ASSERT_EQ(zones.size(), 2U);
    EXPECT_EQ(zones[0].name, "rotor");
    EXPECT_EQ(zones[0].cells, (std::vector<int>{40, 41}));
    EXPECT_EQ(zones[1].name, "FD_0000");
    EXPECT_EQ(zones[1].cells, (std::vector<int>{3, 5}));
    EXPECT_EQ(text_of(folder.path() / "constant/fvOptions"),
              porous_sources({zone}, {}, "fvOptions"));
    EXPECT_EQ(text_of(folder.path() / "constant/fvModels"), porous_sources({zone}, {}, "fvModels"));
}

TEST(WriteCellZones, ReplacesGzippedFile)
{
    const test::TemporaryFolder folder;
    folder.write("constant/polyMesh/cellZones.gz", "");
    write_cell_zones(folder.path(), {{"sac", {1}}});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "constant/polyMesh/cellZones.gz"));
    EXPECT_EQ(read_cell_zones(folder.path()).at(0).name, "sac");
}

TEST(ReadCellZones, NoneWithoutFile)
{
    const test::TemporaryFolder folder;
    EXPECT_TRUE(read_cell_zones(folder.path()).empty());
}

}  // namespace
}  // namespace braidzone
