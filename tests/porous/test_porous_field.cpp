#include "core/error.hpp"
#include "porous/porous_field.hpp"
#include "support/braids.hpp"
#include "support/devices.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace braidzone {
namespace {

const ConstantLaw law{{400.0, 300.0}};
const Fluid fluid{1000.0, 4e-3};  // D = 1e5 1/m, F = 0.6 over the sheet

/// A square sheet of 2 mm in the plane z = 4.8 mm of a tube of 3 mm radius, of cells of 0.1 mm.
ResistanceSheet flat_sheet(const SheetOptions& options = {})
{
    return make_resistance_sheet(test::flat_braid(Vec3(-1e-3, -1e-3, 4.8e-3), Vec3(0.1e-3, 0, 0),
                                                  20, Vec3(0, 0.1e-3, 0), 20, 20e-6),
                                 law, fluid, options);
}

Vessel wide_tube()
{
    return test::tube_vessel(3e-3, 10e-3, 48, 20);
}

FlowDiverter short_device()
{
    FlowDiverter device = test::pipeline_4x20();
    device.nominal_length = 4e-3;
    return device;
}

// Through the middle of a flat sheet in a plane of voxel centres the kernel of half-width 2 leaves
// 1/4, 1/2, 1/4 of the sheet's values on three planes. The spacing is three cells, each one piece,
// so that the sum over the pieces in the plane is exact, too.
TEST(Deposit, FlatSheetMatchesHandCalculation)
{
    const double h = 0.3e-3;
    const PorousField field =
        deposit(flat_sheet({.tangential_ratio = 3.0}), wide_tube(), {.spacing = h});
    const std::int64_t plane = static_cast<std::int64_t>(field.grid.dims[0]) * field.grid.dims[1];
    const Vec3 middle = (Vec3(0, 0, 4.8e-3) - field.grid.origin) / h;
    const auto centre_index = static_cast<std::int64_t>(field.grid.index(
        static_cast<int>(std::lround(middle[0])), static_cast<int>(std::lround(middle[1])),
        static_cast<int>(std::lround(middle[2]))));
    // Metal per area: two families of wire of pi/4 (20 um)^2 every 0.1 mm.
    const double metal_per_area = 2.0 * 0.25 * std::numbers::pi * 20e-6 * 20e-6 / 0.1e-3;
    for (const auto& [offset, weight] :
         {std::pair{-1, 0.25}, std::pair{0, 0.5}, std::pair{1, 0.25}}) {
        const auto found =
            std::find(field.voxels.begin(), field.voxels.end(), centre_index + offset * plane);
        ASSERT_NE(found, field.voxels.end());
        const auto i = static_cast<std::size_t>(found - field.voxels.begin());
        const double per_length = weight / h;
        EXPECT_NEAR(field.surface_density[i], per_length, 1e-9 * per_length);
        EXPECT_NEAR(field.darcy_normal[i], 1e5 * per_length, 1e-4 * per_length);
        EXPECT_NEAR(darcy_tangential(field)[i], 3e5 * per_length, 3e-4 * per_length);
        EXPECT_NEAR(field.forchheimer_normal[i], 0.6 * per_length, 1e-9 * per_length);
        EXPECT_NEAR(field.void_fraction[i], 1.0 - metal_per_area * per_length, 1e-9);
        EXPECT_NEAR((field.normal[i] - Vec3::UnitZ()).norm(), 0.0, 1e-12);
        EXPECT_EQ(cell_type(field, i), CellType::porous);
        // The sheet's own constants, whatever the voxel's share of it.
        EXPECT_NEAR(pressure_loss_linear(field)[i], 400.0, 1e-9);
        EXPECT_NEAR(pressure_loss_quadratic(field)[i], 300.0, 1e-9);
        EXPECT_NEAR(forchheimer_tangential(field)[i], 1.8 * per_length, 1e-9 * per_length);
    }
}

// A sheet in a plane of voxel centres: round-off of its pieces' places must not matter.
TEST(Deposit, TakesSheetsInPlanesOfVoxelCentres)
{
    const double exact = resistance_integral(flat_sheet());
    for (const int planes : {16, 24, 32, 48, 96}) {
        const PorousField field = deposit(flat_sheet(), wide_tube(), {.spacing = 4.8e-3 / planes});
        EXPECT_NEAR(resistance_integral(field), exact, 1e-10 * exact) << planes;
    }
}

TEST(Deposit, GridLiesOnMultiplesOfTheSpacingWithAMargin)
{
    const double h = 0.15e-3;
    const PorousField field =
        deposit(flat_sheet(), wide_tube(), {.spacing = h, .kernel_half_width = 3});
    for (int axis = 0; axis < 3; ++axis) {
        const double index = field.grid.origin[axis] / h;
        EXPECT_NEAR(index, std::round(index), 1e-9);
    }
    const auto& [nx, ny, nz] = field.grid.dims;
    const Vec3 last = field.grid.centre(nx - 1, ny - 1, nz - 1);
    EXPECT_LE(field.grid.origin.x(), -1e-3 - 6.0 * h + 1e-12);
    EXPECT_GE(last.x(), 1e-3 + 6.0 * h - 1e-12);
    EXPECT_LE(field.grid.origin.z(), 4.8e-3 - 6.0 * h + 1e-12);
    EXPECT_GE(last.z(), 4.8e-3 + 6.0 * h - 1e-12);
}

// A device on the wall is metal, but no resistance; every voxel it touches lies in the lumen.
TEST(Deposit, ApposedDeviceIsMetalWithoutResistance)
{
    const FlowDiverter device = short_device();
    const BraidLattice lattice = make_lattice(device);
    const Deployment deployment =
        test::braid_on_cylinder(device, 1.99e-3, lattice.ring_spacing, 8e-3, 1e-6);
    const ResistanceSheet sheet =
        make_resistance_sheet(make_braid_surface(deployment, device), law, fluid);
    const PorousField field = deposit(sheet, test::tube_vessel(2e-3, 10e-3), {.spacing = 0.1e-3});
    EXPECT_EQ(resistance_integral(field), 0.0);
    const double metal = measure(sheet.surface).metal_volume;
    EXPECT_NEAR(metal_volume(field), metal, 1e-10 * metal);
    for (std::size_t i = 0; i < field.voxels.size(); ++i) {
        const std::array<int, 3> place = place_of(field.grid, field.voxels[i]);
        EXPECT_LT(distance_at(field.wall_distance, place[0], place[1], place[2]), 0.0F);
        EXPECT_EQ(cell_type(field, i), CellType::fluid);
        EXPECT_NEAR(field.normal[i].norm(), 1.0, 1e-12);
        EXPECT_GT(field.void_fraction[i], 0.0);
        EXPECT_LT(field.void_fraction[i], 1.0);
    }
}

TEST(Deposit, DoesNotDependOnTheNumberOfThreads)
{
    const FlowDiverter device = short_device();
    const Deployment deployment = test::braid_on_cylinder(device, 1.7e-3, 0.15e-3, 8e-3);
    const ResistanceSheet sheet =
        make_resistance_sheet(make_braid_surface(deployment, device), law, fluid);
    const Vessel vessel = test::tube_vessel(2e-3, 10e-3);
    const PorousField many = deposit(sheet, vessel, {.spacing = 0.15e-3});
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const PorousField one = deposit(sheet, vessel, {.spacing = 0.15e-3});
    EXPECT_EQ(one.voxels, many.voxels);
    EXPECT_EQ(one.darcy_normal, many.darcy_normal);
    EXPECT_EQ(one.forchheimer_normal, many.forchheimer_normal);
    EXPECT_EQ(one.void_fraction, many.void_fraction);
    EXPECT_EQ(one.normal, many.normal);
    EXPECT_EQ(one.wall_distance.of_voxels, many.wall_distance.of_voxels);
    EXPECT_EQ(one.wall_distance.of_cubes, many.wall_distance.of_cubes);
}

template <typename Thrown>
std::string message_of(const ResistanceSheet& sheet, const DepositOptions& options)
{
    try {
        deposit(sheet, wide_tube(), options);
    } catch (const Thrown& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(Deposit, RefusesBadOptions)
{
    const ResistanceSheet sheet = flat_sheet();
    EXPECT_NE(message_of<ConfigError>(sheet, {.spacing = 0.0}).find("grid.spacing = 0 m"),
              std::string::npos);
    EXPECT_NE(message_of<ConfigError>(sheet, {.spacing = std::nan("")}).find("grid.spacing = nan"),
              std::string::npos);
    EXPECT_NE(message_of<ConfigError>(sheet, {.kernel_half_width = 0}).find("0 voxels"),
              std::string::npos);
    // 2 mm in steps of 0.1 um, squared, is 4e8 voxels a plane, of which 8 or more are held; in
    // steps of 5 nm, 1.6e11.
    const std::string fine = message_of<ConfigError>(sheet, {.spacing = 0.1e-6});
    EXPECT_NE(fine.find("voxels on the device; at most 1e+09"), std::string::npos) << fine;
    const std::string finer = message_of<ConfigError>(sheet, {.spacing = 5e-9});
    EXPECT_NE(finer.find("at most 1e+11 in all"), std::string::npos) << finer;
}

TEST(Deposit, RefusesASheetOutsideTheVessel)
{
    const ResistanceSheet sheet = make_resistance_sheet(
        test::flat_braid(Vec3(10e-3, 0, 5e-3), Vec3(0.2e-3, 0, 0), 2, Vec3(0, 0.2e-3, 0), 2, 30e-6),
        law, fluid);
    const std::string message = message_of<GeometryError>(sheet, {.spacing = 0.1e-3});
    EXPECT_NE(message.find("rhombus 0"), std::string::npos) << message;
    EXPECT_NE(message.find("(10.0"), std::string::npos) << message;
}

}  // namespace
}  // namespace braidzone
