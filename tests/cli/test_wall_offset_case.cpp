#include "cli/case_geometry.hpp"
#include "core/centerline_io.hpp"
#include "core/error.hpp"
#include "core/triangle_mesh.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace braidzone {
namespace {

using testing::HasSubstr;

constexpr double radius = 1.85e-3, length = 26e-3;

void write_ply(const std::filesystem::path& file, const TriangleMesh& mesh)
{
    std::ofstream text(file);
    text << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3& point : mesh.points)
        text << fmt::format("{} {} {}\n", 1e3 * point.x(), 1e3 * point.y(), 1e3 * point.z());
    for (const auto& corners : mesh.triangles)
        text << fmt::format("3 {} {} {}\n", corners[0], corners[1], corners[2]);
}

/// A tube along z with a line in its middle, which says the radius if `stored`.
class TubeOnDisk {
public:
    TubeOnDisk(double tube_radius, bool stored)
    {
        source.surface = folder_.path() / "vessel.ply";
        source.unit = {};
        write_ply(source.surface, test::tube(tube_radius, length, 96, 120));
        Polyline line;
        for (int i = 0; i <= 100; ++i)
            line.points.emplace_back(0.0, 0.0, length * i / 100.0);
        if (stored) line.inscribed_radii.assign(line.points.size(), tube_radius);
        source.centerline = folder_.path() / "line.vtp";
        write_centerline(*source.centerline, line, source.unit);
    }

    Polyline line() const
    {
        const Vessel vessel = read_vessel(source);
        return find_centerline(source, vessel, WallTree(vessel)).line;
    }

    VesselSource source;

private:
    test::TemporaryFolder folder_;
};

// A tube that is moved outwards is the tube of the larger radius: its line has the same radii,
// whether the file states those of the wall as it was or none. The prism's sides lie up to
// r (1 - cos(pi / 96)) = 1 um inside its corners, where the stored radius is measured.
TEST(WallOffset, MovesTheRadiiOfAGivenLineWithTheWall)
{
    for (const double offset : {-0.2e-3, -0.1e-3, 0.1e-3, 0.2e-3, 0.3e-3, 0.5e-3}) {
        const TubeOnDisk remeshed(radius + offset, true);
        const std::vector<double> expected = remeshed.line().inscribed_radii;
        for (const bool stored : {true, false}) {
            TubeOnDisk moved(radius, stored);
            moved.source.wall_offset = offset;
            const std::vector<double> found = moved.line().inscribed_radii;
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t i = 0; i < found.size(); ++i)
                EXPECT_NEAR(found[i], expected[i], 2e-6) << offset << " " << stored << " " << i;
        }
    }
}

// A tube of 1.85 mm whose wall moves 1.9 mm inwards is turned inside out. The file is sound.
TEST(WallOffset, IsNamedWhereItSpoilsASoundSurface)
{
    TubeOnDisk tube(radius, true);
    tube.source.wall_offset = -1.9e-3;
    try {
        tube.line();
        FAIL() << "accepted";
    } catch (const GeometryError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the surface is sound as it is, and no longer with "
                                            "vessel.wall_offset = -1.9 mm"));
    }
}

}  // namespace
}  // namespace braidzone
