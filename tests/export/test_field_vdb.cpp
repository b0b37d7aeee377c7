#include "core/error.hpp"
#include "export/field_vdb.hpp"
#include "support/braids.hpp"
#include "support/fields.hpp"
#include "support/python.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

namespace braidzone {
namespace {

const LengthUnit millimetre{"mm", 1e-3};

std::string content(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class FieldVdb : public testing::Test {
protected:
    FieldVdb()
    {
        write_field_vdb(path, field, millimetre);
        openvdb::initialize();
        openvdb::io::File file(path.string());
        file.open();
        grids = *file.getGrids();
    }

    openvdb::GridBase::Ptr base_grid(const std::string& name) const
    {
        for (const openvdb::GridBase::Ptr& candidate : grids) {
            if (candidate->getName() == name) return candidate;
        }
        return nullptr;
    }
    template <typename Grid>
    typename Grid::Ptr grid(const std::string& name) const
    {
        return openvdb::gridPtrCast<Grid>(base_grid(name));
    }
    /// Value of a grid at a point of the field [m], found by OpenVDB from its transform.
    template <typename Grid>
    typename Grid::ValueType value_at(const std::string& name, const Vec3& point) const
    {
        const auto found = grid<Grid>(name);
        const Vec3 position = point / millimetre.metres;
        const openvdb::Vec3d index =
            found->transform().worldToIndex({position[0], position[1], position[2]});
        return found->tree().getValue(openvdb::Coord::round(index));
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "field.vdb";
    PorousField field = test::asymmetric_field();
    openvdb::GridPtrVec grids;
};

TEST_F(FieldVdb, HoldsAllGridsWithTheirUnits)
{
    const std::pair<const char*, const char*> units[] = {{"void_fraction", "1"},
                                                         {"surface_density", "1/m"},
                                                         {"darcy_normal", "1/m^2"},
                                                         {"darcy_tangential", "1/m^2"},
                                                         {"forchheimer_normal", "1/m"},
                                                         {"forchheimer_tangential", "1/m"},
                                                         {"pressure_loss_linear", "Pa s/m"},
                                                         {"pressure_loss_quadratic", "Pa s^2/m^2"},
                                                         {"normal", "1"},
                                                         {"wall_distance", "m"},
                                                         {"cell_type", "1"}};
    ASSERT_EQ(grids.size(), std::size(units));
    for (const auto& [name, unit] : units) {
        const auto found = base_grid(name);
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(found->metaValue<std::string>("unit"), unit) << name;
        EXPECT_EQ(found->metaValue<std::string>("length_unit"), "mm") << name;
        EXPECT_FALSE(found->saveFloatAsHalf()) << name;
        EXPECT_EQ(found->getGridClass(),
                  std::string(name) == "normal" ? openvdb::GRID_UNKNOWN : openvdb::GRID_FOG_VOLUME)
            << name;
    }
}

TEST_F(FieldVdb, SaysWhereItLiesAndComesFrom)
{
    const FileOrigin origin{"Braidzone 1.2.3", "abc123"};
    write_field_vdb(path, field, millimetre, origin);
    const std::string printed =
        test::printed_by_python(folder.path(),
                                "import pyopenvdb as v\n"
                                "g = v.read('field.vdb', 'void_fraction')\n"
                                "print(g['generator'], g['case_hash'])\n"
                                "print(g['length_unit'], g['length_unit_m'])\n"
                                "print('%.6g' % g['dx_m'], g['dims'])\n"
                                "print(['%.6g' % x for x in g['origin']])\n"
                                "print(g['background'], g.background)\n"
                                "print(g.gridClass, g.saveFloatAsHalf)\n");
    EXPECT_EQ(printed,
              "Braidzone 1.2.3 abc123\n"
              "mm 0.001\n"
              "0.0002 (4, 5, 6)\n"
              "['1', '-2', '3']\n"
              "1.0 1.0\n"
              "fog volume False\n");
}

// 1e-5 m are 1e-5 of the length unit.
TEST_F(FieldVdb, RefusesVoxelsThatOpenVdbCannotPlace)
{
    field.grid.spacing = 1e-5;
    try {
        write_field_vdb(path, field, LengthUnit{"m", 1.0});
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_STREQ(
            error.what(),
            "grid.spacing = 0.01 mm is 1e-05 of the vessel's length unit, m; OpenVDB takes "
            "voxels of 1.45e-05 or more: state the vessel in a smaller unit, or raise "
            "grid.spacing");
    }
    field.grid.spacing = 1.46e-5;
    EXPECT_NO_THROW(write_field_vdb(path, field, LengthUnit{"m", 1.0}));
}

TEST_F(FieldVdb, EveryVoxelIsFoundAtItsPlace)
{
    for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 4; ++i) {
                const Vec3 centre = field.grid.centre(i, j, k);
                const std::size_t index = field.grid.index(i, j, k);
                EXPECT_EQ(value_at<openvdb::FloatGrid>("wall_distance", centre),
                          distance_at(field.wall_distance, i, j, k));
                EXPECT_EQ(value_at<openvdb::FloatGrid>("cell_type", centre),
                          static_cast<float>(test::expected_cell_type(field, index)));
            }
        }
    }
}

TEST_F(FieldVdb, TouchedVoxelsHoldTheirValues)
{
    const std::array<Vec3, 2> places{field.grid.centre(1, 2, 3), field.grid.centre(2, 0, 5)};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto expect = [&](const char* name, double value) {
            EXPECT_EQ(value_at<openvdb::FloatGrid>(name, places[i]), static_cast<float>(value))
                << name;
        };
        expect("void_fraction", field.void_fraction[i]);
        expect("surface_density", field.surface_density[i]);
        expect("darcy_normal", field.darcy_normal[i]);
        expect("darcy_tangential", 2.0 * field.darcy_normal[i]);
        expect("forchheimer_normal", field.forchheimer_normal[i]);
        expect("forchheimer_tangential", 0.5 * field.forchheimer_normal[i]);
        expect("pressure_loss_linear", pressure_loss_linear(field)[i]);
        expect("pressure_loss_quadratic", pressure_loss_quadratic(field)[i]);
        const openvdb::Vec3s normal = value_at<openvdb::Vec3SGrid>("normal", places[i]);
        for (int c = 0; c < 3; ++c)
            EXPECT_FLOAT_EQ(normal[c], field.normal[i][c]);
    }
    for (const char* name : {"void_fraction", "darcy_normal", "forchheimer_normal"}) {
        EXPECT_EQ(grid<openvdb::FloatGrid>(name)->activeVoxelCount(), 2U) << name;
    }
    EXPECT_EQ(value_at<openvdb::FloatGrid>("void_fraction", field.grid.origin), 1.0F);
    EXPECT_EQ(value_at<openvdb::FloatGrid>("darcy_normal", field.grid.origin), 0.0F);
}

/// A sheet of 4 mm across a tube of 8 mm, in voxels of 0.1 mm: cubes without wall and device exist.
PorousField field_with_tiles()
{
    const BraidSurface surface = test::flat_braid(Vec3(-2e-3, -2e-3, 6e-3), Vec3(0.2e-3, 0, 0), 20,
                                                  Vec3(0, 0.2e-3, 0.05e-3), 20, 33e-6);
    const ResistanceSheet sheet = make_resistance_sheet(surface, BraidStokesLaw{}, Fluid{});
    return deposit(sheet, test::tube_vessel(3.4e-3, 12e-3, 48, 24), {.spacing = 0.05e-3});
}

// Where neither wall nor device is, a leaf of the tree is one number with the right sign.
TEST(FieldVdbTiles, HoldTheLumenBetweenWallAndDevice)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "field.vdb";
    const PorousField field = field_with_tiles();
    ASSERT_LT(field.wall_distance.cubes.held.size(), field.wall_distance.cubes.num_cubes());
    write_field_vdb(path, field, millimetre);
    openvdb::initialize();
    openvdb::io::File file(path.string());
    file.open();
    const auto distance = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("wall_distance"));
    const auto type = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("cell_type"));
    const auto& [nx, ny, nz] = field.grid.dims;
    std::size_t in_lumen = 0;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const float expected = distance_at(field.wall_distance, i, j, k);
                ASSERT_EQ(distance->tree().getValue({i, j, k}), expected);
                ASSERT_EQ(type->tree().getValue({i, j, k}) > 0.0F, expected < 0.0F);
                in_lumen += expected < 0.0F;
            }
        }
    }
    EXPECT_GT(in_lumen, 0U);
    // Cubes that reach over the grid end with it.
    EXPECT_EQ(type->activeVoxelCount(), in_lumen);
    EXPECT_LT(distance->tree().leafCount(), field.wall_distance.cubes.num_cubes());
}

// As acceptance does it: active values times the voxel's volume.
TEST_F(FieldVdb, KeepsTheResistanceIntegral)
{
    const auto darcy = grid<openvdb::FloatGrid>("darcy_normal");
    double sum = 0.0;
    for (auto value = darcy->cbeginValueOn(); value; ++value) {
        sum += static_cast<double>(*value) * static_cast<double>(value.getVoxelCount());
    }
    const double volume = darcy->transform().voxelVolume() * std::pow(millimetre.metres, 3);
    const double exact = resistance_integral(field);
    EXPECT_NEAR(sum * volume, exact, 1e-6 * exact);
}

TEST_F(FieldVdb, IsTheSameBytesEachTime)
{
    const std::filesystem::path again = folder.path() / "again.vdb";
    write_field_vdb(again, field, millimetre);
    EXPECT_EQ(content(again), content(path));
}

TEST_F(FieldVdb, MarkChangesWithTheContent)
{
    const std::filesystem::path other = folder.path() / "other.vdb";
    PorousField changed = field;
    changed.darcy_normal[0] *= 2.0;
    write_field_vdb(other, changed, millimetre);
    const auto mark = [](const std::filesystem::path& file) {
        return content(file).substr(21, 36);
    };
    EXPECT_NE(mark(other), mark(path));
    EXPECT_EQ(mark(path)[14], '8');
}

TEST_F(FieldVdb, UnwritablePathIsReported)
{
    const std::filesystem::path nowhere = folder.path() / "absent" / "field.vdb";
    try {
        write_field_vdb(nowhere, field, millimetre);
        FAIL() << "nothing was thrown";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find(nowhere.string()), std::string::npos);
    }
}

}  // namespace
}  // namespace braidzone
