#include "export/foam_sac.hpp"
#include "support/foam_box.hpp"

#include <gtest/gtest.h>

namespace braidzone {
namespace {

/// Resistance on the cells whose centres have z in this range.
CellResistance layer_of(const FoamMesh& mesh, double z_lower, double z_upper)
{
    CellResistance resistance;
    for (int cell = 0; cell < mesh.num_cells(); ++cell) {
        const double z = mesh.cell_centres[static_cast<std::size_t>(cell)].z();
        if (z < z_lower || z > z_upper) continue;
        resistance.cells.push_back(cell);
        resistance.darcy.push_back(1e8);
        resistance.forchheimer.push_back(0.0);
        resistance.normal.push_back(Vec3::UnitZ());
    }
    return resistance;
}

/// A block whose openings (x lower, x upper) reach up to z = `open_height` only, as if a sac of the
/// block's remaining height stood on a vessel.
FoamMesh vessel_with_sac(double open_height)
{
    FoamMesh mesh = test::foam_box({8, 4, 10}, 1.0);
    // Cells are ordered by z, so the patches' lower faces come first; the rest becomes wall.
    for (FoamPatch& patch : mesh.patches)
        if (patch.type == "patch") patch.num_faces = static_cast<int>(4 * open_height);
    return mesh;
}

TEST(FindSac, IsWhatTheDeviceClosesOff)
{
    const FoamMesh mesh = vessel_with_sac(3);
    const auto sacs = find_sacs(layer_of(mesh, 3.0, 4.0), mesh);
    ASSERT_EQ(sacs.size(), 1U);
    const std::vector<int>& sac = sacs.front();
    ASSERT_EQ(sac.size(), 8U * 4U * 6U);  // layers 4 to 9
    for (const int cell : sac)
        EXPECT_GT(mesh.cell_centres[static_cast<std::size_t>(cell)].z(), 4.0);
}

// Layers 0 and 1, and 5 to 9, on both sides of a vessel of two layers between two sheets.
TEST(FindSac, TellsTwoSacsApartTheLargerFirst)
{
    FoamMesh mesh = test::foam_box({8, 4, 10}, 1.0);
    for (FoamPatch& patch : mesh.patches) {
        if (patch.type != "patch") continue;
        patch.start_face += 4 * 3;
        patch.num_faces = 4;
    }
    CellResistance resistance = layer_of(mesh, 2.0, 3.0);
    const CellResistance upper = layer_of(mesh, 4.0, 5.0);
    resistance.cells.insert(resistance.cells.end(), upper.cells.begin(), upper.cells.end());
    const auto sacs = find_sacs(resistance, mesh);
    ASSERT_EQ(sacs.size(), 2U);
    EXPECT_EQ(sacs[0].size(), 8U * 4U * 5U);
    EXPECT_EQ(sacs[1].size(), 8U * 4U * 2U);
    EXPECT_EQ(sacs[1].front(), 0);
}

TEST(FindSac, NoneIfFlowGoesAroundTheDevice)
{
    const FoamMesh mesh = vessel_with_sac(3);
    CellResistance resistance = layer_of(mesh, 3.0, 4.0);
    resistance.cells.erase(resistance.cells.begin());
    EXPECT_TRUE(find_sacs(resistance, mesh).empty());
}

// As a branch behind the device: the openings reach above it.
TEST(FindSac, NoneIfAnOpeningLiesBehindTheDevice)
{
    const FoamMesh mesh = vessel_with_sac(10);
    EXPECT_TRUE(find_sacs(layer_of(mesh, 3.0, 4.0), mesh).empty());
}

// A pocket of one layer behind a sheet of six layers has a sixth of its volume.
TEST(FindSac, SmallPocketsAreNoSac)
{
    const FoamMesh mesh = vessel_with_sac(3);
    EXPECT_TRUE(find_sacs(layer_of(mesh, 3.0, 9.0), mesh).empty());
}

TEST(FindSac, NoneWithoutResistance)
{
    EXPECT_TRUE(find_sacs(CellResistance{}, vessel_with_sac(3)).empty());
}

}  // namespace
}  // namespace braidzone
