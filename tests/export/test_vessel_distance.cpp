#include "core/error.hpp"
#include "export/vessel_distance.hpp"
#include "support/python.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetMeasure.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

constexpr double radius = 2e-3, length = 10e-3;

openvdb::FloatGrid::Ptr read_grid(const std::filesystem::path& path)
{
    openvdb::initialize();
    openvdb::io::File file(path.string());
    file.open();
    return openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("vessel_distance"));
}

openvdb::FloatGrid::Ptr distance_of(const Vessel& vessel, double spacing)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "distance.vdb";
    write_vessel_distance(path, vessel, spacing);
    return read_grid(path);
}

/// Signed distance to a cylinder along z with flat ends [mm].
double distance_to_cylinder(double x, double y, double z)
{
    const double side = std::hypot(x, y) - 1e3 * radius;
    const double end = std::abs(z - 0.5e3 * length) - 0.5e3 * length;
    if (side > 0.0 && end > 0.0) return std::hypot(side, end);
    return std::max(side, end);
}

double largest_error(const openvdb::FloatGrid& grid)
{
    double largest = 0.0;
    for (auto value = grid.cbeginValueOn(); value; ++value) {
        const openvdb::Vec3d at = grid.indexToWorld(value.getCoord());
        const double exact = distance_to_cylinder(at.x(), at.y(), at.z());
        largest = std::max(largest, std::abs(static_cast<double>(*value) - exact));
    }
    return largest;
}

// In the band the distance is exact: all that is wrong is the prism for the cylinder, R (1 -
// cos(pi / n)) at most, and with twice as many facets a quarter of that.
TEST(VesselDistance, IsThatOfATubeInSecondOrderOfItsFacets)
{
    const auto sag = [](int facets) {
        return 1e3 * radius * (1.0 - std::cos(std::numbers::pi / facets));
    };
    const double coarse =
        largest_error(*distance_of(test::tube_vessel(radius, length, 48), 0.1e-3));
    const double fine = largest_error(*distance_of(test::tube_vessel(radius, length, 96), 0.1e-3));
    EXPECT_LE(coarse, 1.02 * sag(48));
    EXPECT_LE(fine, 1.02 * sag(96));
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
}

// Over the voxels: the volume inside the level 0, by OpenVDB, against pi R^2 L.
TEST(VesselDistance, EnclosesTheLumensVolumeInSecondOrderOfTheSpacing)
{
    const Vessel vessel = test::tube_vessel(radius, length, 384);
    const double exact = std::numbers::pi * 1e9 * radius * radius * length;
    const auto error = [&](double spacing) {
        const auto grid = distance_of(vessel, spacing);
        return std::abs(openvdb::tools::levelSetVolume(*grid, true) - exact) / exact;
    };
    const double coarse = error(0.2e-3), fine = error(0.1e-3);
    EXPECT_LT(coarse, 0.02);
    EXPECT_GT(std::log2(coarse / fine), 1.5);
}

// As a user reads it: a level set in the vessel's unit, negative inside, on multiples of the
// spacing.
TEST(VesselDistance, IsALevelSetForDebiansPython)
{
    const test::TemporaryFolder folder;
    write_vessel_distance(folder.path() / "d.vdb", test::tube_vessel(radius, length, 96), 0.1e-3,
                          {"Braidzone 1.2.3", "abc"});
    EXPECT_EQ(test::printed_by_python(folder.path(),
                                      "import pyopenvdb as v\n"
                                      "g, = v.readAllGridMetadata('d.vdb')\n"
                                      "g = v.read('d.vdb', g.name)\n"
                                      "print(g.name, g.gridClass, '%.3f' % g.background)\n"
                                      "print(g['unit'], g['length_unit'], g['length_unit_m'])\n"
                                      "print(g['generator'], g['case_hash'], '%.6g' % g['dx_m'])\n"
                                      "print(g.transform.indexToWorld((10, 0, 20)) == "
                                      "g.transform.indexToWorld((0, 0, 0)))\n"
                                      "print(['%.4f' % x for x in "
                                      "g.transform.indexToWorld((10, 0, 20))])\n"
                                      "a = g.getAccessor()\n"
                                      "print('%.3f %.3f %.3f' % tuple(a.getValue((i, 0, 50)) "
                                      "for i in (0, 19, 21)))\n"),
              "vessel_distance level set 0.300\n"
              "mm mm 0.001\n"
              "Braidzone 1.2.3 abc 0.0001\n"
              "False\n"
              "['1.0000', '0.0000', '2.0000']\n"
              "-0.300 -0.100 0.100\n");
}

TEST(VesselDistance, RefusesSpacingsThatAreTooCoarseOrTooFine)
{
    const test::TemporaryFolder folder;
    const auto message = [&](const Vessel& vessel, double spacing) -> std::string {
        try {
            write_vessel_distance(folder.path() / "d.vdb", vessel, spacing);
        } catch (const ConfigError& error) {
            return error.what();
        }
        return "";
    };
    const Vessel tube = test::tube_vessel(radius, length, 96);
    EXPECT_THAT(message(tube, 0.7e-3),
                testing::HasSubstr("export.distance_spacing = 0.7 mm is too coarse for an opening "
                                   "of radius"));
    EXPECT_THAT(message(tube, 2e-6), testing::HasSubstr("would make a grid of"));
    Vessel in_metres = tube;
    in_metres.unit = {"m", 1.0};
    EXPECT_THAT(message(in_metres, 1e-5), testing::HasSubstr("OpenVDB takes voxels of"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "d.vdb"));
}

TEST(VesselDistance, UnwritablePathIsReported)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_vessel_distance(folder.path() / "absent" / "d.vdb",
                                       test::tube_vessel(radius, length, 48), 0.2e-3),
                 IoError);
}

}  // namespace
}  // namespace braidzone
