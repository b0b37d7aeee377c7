#include "core/error.hpp"
#include "export/foam_cell_zones.hpp"
#include "export/foam_zones.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace braidzone {
namespace {

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

// The tangential ratios scale D and F along the sheet.
TEST(ZoneSources, HaveTheTensorAlongTheZonesAxes)
{
    FoamZone zone;
    zone.darcy = 4e8;
    zone.forchheimer = 5e3;
    zone.normal = Vec3::UnitZ();
    const auto sources = zone_sources({zone, zone}, {0.25, 0.1});
    ASSERT_EQ(sources.size(), 2U);
    EXPECT_EQ(sources[1].cell_zone, "FD_0001");
    EXPECT_EQ(sources[1].darcy, Vec3(4e8, 1e8, 1e8));
    EXPECT_EQ(sources[1].forchheimer, Vec3(5e3, 5e2, 5e2));
    EXPECT_EQ(sources[1].e1, Vec3::UnitZ());
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
