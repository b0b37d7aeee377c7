#include "core/error.hpp"
#include "export/foam_resistance.hpp"
#include "support/braids.hpp"
#include "support/foam_box.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <map>
#include <numbers>

namespace braidzone {
namespace {

constexpr double cell = 0.1e-3;  // [m]
const Fluid blood;
const SheetLoss loss{490.0, 330.0};  // reference cell of a 48-wire device

/// A square flat sheet of side `side` around `centre`, its normal turned from x by `slant` about z
/// and then by the same angle about y.
ResistanceSheet flat_sheet(const Vec3& centre, double side, double slant)
{
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(slant, Vec3::UnitY()) * Eigen::AngleAxisd(slant, Vec3::UnitZ()))
            .toRotationMatrix();
    constexpr int count = 10;
    const Vec3 a = turn * Vec3::UnitY() * (side / count), b = turn * Vec3::UnitZ() * (side / count);
    const Vec3 origin = centre - 0.5 * count * (a + b);
    return make_resistance_sheet(test::flat_braid(origin, a, count, b, count, 30e-6),
                                 ConstantLaw{loss}, blood);
}

double forchheimer_integral(const CellResistance& resistance, const FoamMesh& mesh)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < resistance.cells.size(); ++i)
        sum += resistance.forchheimer[i] *
               mesh.cell_volumes[static_cast<std::size_t>(resistance.cells[i])];
    return sum;
}

// By hand: 490 / 3.5e-3 = 1.4e5 1/m over 1 mm^2 is 0.14 m; 2 330 / 1056 = 0.625 over 1 mm^2.
TEST(FoamDeposit, KeepsTheIntegralsAtAnySlant)
{
    const FoamMesh mesh = test::foam_box({24, 24, 24}, cell);
    for (const double slant : {0.0, 0.3, std::numbers::pi / 4.0}) {
        const auto sheet = flat_sheet(Vec3(1.21e-3, 1.17e-3, 1.23e-3), 1e-3, slant);
        const CellResistance resistance = deposit(sheet, mesh);
        EXPECT_NEAR(resistance_integral(resistance, mesh), 0.14, 1e-13) << slant;
        EXPECT_NEAR(forchheimer_integral(resistance, mesh), 0.625e-6, 1e-18) << slant;
        EXPECT_TRUE(resistance.warnings.empty());
    }
}

// The box ends 0.05 mm behind the sheet: three quarters of the kernel's length there are cut off.
TEST(FoamDeposit, KeepsTheIntegralWhereTheWallCutsTheKernelOff)
{
    const FoamMesh mesh = test::foam_box({12, 24, 24}, cell);
    const auto sheet = flat_sheet(Vec3(1.15e-3, 1.2e-3, 1.2e-3), 1e-3, 0.0);
    EXPECT_NEAR(resistance_integral(deposit(sheet, mesh), mesh), 0.14, 1e-13);
}

// Flow along any line through the sheet must meet the same resistance: the sum of D h over a column
// of cells in the middle of a large sheet is a / mu = 1.4e5 1/m wherever the sheet lies between the
// cells. The cosine kernel sums to 1 exactly on a line of cells; what scatters is the quadrature.
TEST(FoamDeposit, ColumnsOfCellsMeetTheSheetsResistance)
{
    const FoamMesh mesh = test::foam_box({16, 20, 20}, cell);
    for (const double offset : {0.0, 0.21, 0.5, 0.83}) {
        const auto sheet = flat_sheet(Vec3((7.0 + offset) * cell, 1e-3, 1e-3), 2e-3, 0.0);
        std::map<int, double> columns;  // cells of one column differ by less than nx = 16
        const CellResistance resistance = deposit(sheet, mesh);
        for (std::size_t i = 0; i < resistance.cells.size(); ++i)
            columns[resistance.cells[i] / 16] += resistance.darcy[i] * cell;
        // Columns within the tangential kernel (2 cells) of the sheet's edge are left out.
        for (int k = 4; k < 16; ++k)
            for (int j = 4; j < 16; ++j)
                EXPECT_NEAR(columns.at(j + 20 * k) / 1.4e5, 1.0, 0.01) << offset;
    }
}

// A slanted sheet: the mean over columns of the resistance along the normal (column sum times the
// cosine of the angle). Scatter between columns is the quadrature's on a grid; it is below 3 %.
TEST(FoamDeposit, SlantedSheetHasTheSameResistanceAlongItsNormal)
{
    const FoamMesh mesh = test::foam_box({30, 30, 30}, cell);
    const double slant = 0.5;
    const auto sheet = flat_sheet(Vec3(1.5e-3, 1.5e-3, 1.5e-3), 2.4e-3, slant);
    const double cosine = sheet.surface.normals[0].x();
    std::map<int, double> columns;
    const CellResistance resistance = deposit(sheet, mesh);
    for (std::size_t i = 0; i < resistance.cells.size(); ++i)
        columns[resistance.cells[i] / 30] += resistance.darcy[i] * cell;
    double sum = 0.0;
    for (int k = 12; k < 18; ++k)
        for (int j = 12; j < 18; ++j) {
            const double along_normal = columns.at(j + 30 * k) * cosine / 1.4e5;
            EXPECT_NEAR(along_normal, 1.0, 0.03);
            sum += along_normal;
        }
    EXPECT_NEAR(sum / 36.0, 1.0, 0.005);
}

// Metal and area count for the whole device, also where it lies on the wall: 1 mm^2 with two
// families of pi/4 (30 um)^2 wire every 0.1 mm, 1.4137e-5 m a m^2.
TEST(FoamDeposit, KeepsAreaAndMetalOfTheWholeDevice)
{
    const FoamMesh mesh = test::foam_box({24, 24, 24}, cell);
    auto sheet = flat_sheet(Vec3(1.21e-3, 1.17e-3, 1.23e-3), 1e-3, 0.3);
    for (std::size_t i = 0; i < 50; ++i)
        sheet.acting[i] = 0.0;
    const CellMetal metal = deposit(sheet, mesh).metal;
    double area = 0.0, volume = 0.0;
    for (std::size_t i = 0; i < metal.cells.size(); ++i) {
        const double cell_volume = mesh.cell_volumes[static_cast<std::size_t>(metal.cells[i])];
        area += metal.surface_density[i] * cell_volume;
        volume += (1.0 - metal.void_fraction[i]) * cell_volume;
    }
    EXPECT_NEAR(area / 1e-6, 1.0, 1e-12);
    EXPECT_NEAR(volume / measure(sheet.surface).metal_volume, 1.0, 1e-11);
}

TEST(FoamDeposit, DoesNotDependOnTheNumberOfThreads)
{
    const FoamMesh mesh = test::foam_box({24, 24, 24}, cell);
    const auto sheet = flat_sheet(Vec3(1.21e-3, 1.17e-3, 1.23e-3), 1e-3, 0.3);
    const CellResistance many = deposit(sheet, mesh);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const CellResistance one = deposit(sheet, mesh);
    EXPECT_EQ(one.cells, many.cells);
    EXPECT_EQ(one.darcy, many.darcy);
    EXPECT_EQ(one.normal, many.normal);
    EXPECT_EQ(one.metal.void_fraction, many.metal.void_fraction);
}

TEST(FoamDeposit, NormalIsTheSheets)
{
    const FoamMesh mesh = test::foam_box({24, 24, 24}, cell);
    const auto sheet = flat_sheet(Vec3(1.2e-3, 1.2e-3, 1.2e-3), 1e-3, 0.4);
    for (const Vec3& normal : deposit(sheet, mesh).normal)
        EXPECT_LT((normal - sheet.surface.normals[0]).norm(), 1e-12);
}

// Two boxes a hundredth of a cell apart that share no face: the sheet lies in the first.
TEST(FoamDeposit, NothingReachesTheLumenBehindAThinWall)
{
    FoamMesh mesh = test::foam_box({12, 20, 20}, cell);
    const FoamMesh other = test::foam_box({12, 20, 20}, cell, Vec3(12.01 * cell, 0, 0));
    const int num_first = mesh.num_cells();
    mesh.cell_centres.insert(mesh.cell_centres.end(), other.cell_centres.begin(),
                             other.cell_centres.end());
    mesh.cell_volumes.insert(mesh.cell_volumes.end(), other.cell_volumes.begin(),
                             other.cell_volumes.end());
    // Internal faces alone decide about the neighbourhood.
    mesh.owner.resize(mesh.neighbour.size());
    for (std::size_t f = 0; f < other.neighbour.size(); ++f) {
        mesh.owner.push_back(other.owner[f] + num_first);
        mesh.neighbour.push_back(other.neighbour[f] + num_first);
    }
    const auto sheet = flat_sheet(Vec3(1.15e-3, 1e-3, 1e-3), 1e-3, 0.0);
    const CellResistance resistance = deposit(sheet, mesh);
    EXPECT_LT(resistance.cells.back(), num_first);
    EXPECT_NEAR(resistance_integral(resistance, mesh), 0.14, 1e-13);
}

TEST(FoamDeposit, PartOnTheWallGivesNothing)
{
    const FoamMesh mesh = test::foam_box({24, 24, 24}, cell);
    auto sheet = flat_sheet(Vec3(1.2e-3, 1.2e-3, 1.2e-3), 1e-3, 0.0);
    for (std::size_t i = 0; i < sheet.acting.size(); ++i)
        sheet.acting[i] = i < 50 ? 0.0 : 0.5;
    EXPECT_NEAR(resistance_integral(deposit(sheet, mesh), mesh), 0.25 * 0.14, 1e-13);
    for (double& acting : sheet.acting)
        acting = 0.0;
    EXPECT_TRUE(deposit(sheet, mesh).cells.empty());
}

// A mesh at another position than the vessel's, 10 mm away.
TEST(FoamDeposit, RefusesMeshThatDoesNotHoldTheDevice)
{
    const FoamMesh mesh = test::foam_box({24, 24, 24}, cell, Vec3(0.01, 0, 0));
    const auto sheet = flat_sheet(Vec3(1.2e-3, 1.2e-3, 1.2e-3), 1e-3, 0.0);
    try {
        deposit(sheet, mesh);
        FAIL() << "no error";
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find("the mesh does not hold the device: rhombus 0 at"),
                  std::string::npos)
            << error.what();
    }
}

TEST(FoamDeposit, RefusesKernelsOfLessThanACell)
{
    const FoamMesh mesh = test::foam_box({4, 4, 4}, cell);
    const auto sheet = flat_sheet(Vec3(0.2e-3, 0.2e-3, 0.2e-3), 0.1e-3, 0.0);
    EXPECT_THROW(deposit(sheet, mesh, {.kernel_half_width = 0.5}), InputError);
    EXPECT_THROW(deposit(sheet, mesh, {.tangential_half_width = std::nan("")}), InputError);
}

TEST(FoamDeposit, WarnsOfCoarseMesh)
{
    const FoamMesh mesh = test::foam_box({24, 24, 24}, cell);
    const auto sheet = flat_sheet(Vec3(1.2e-3, 1.2e-3, 1.2e-3), 1e-3, 0.0);
    const auto resistance = deposit(sheet, mesh, {.kernel_half_width = 1.5});
    ASSERT_EQ(resistance.warnings.size(), 1U);
    EXPECT_NE(resistance.warnings[0].find("fewer than 4 cells across"), std::string::npos);
}

}  // namespace
}  // namespace braidzone
