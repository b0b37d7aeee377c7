#include "export/vessel_distance.hpp"

#include "core/error.hpp"
#include "export/vdb_labels.hpp"
#include "export/vdb_mark.hpp"

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include <algorithm>
#include <vector>

namespace braidzone {

namespace {

constexpr const char* spacing_key = "export.distance_spacing";
constexpr float half_width = 3.0F;  // of the band, in voxels; OpenVDB's usual one

void require_usable(double spacing, const Vessel& vessel, double area)
{
    require_vdb_spacing(spacing_key, spacing, vessel.unit);
    double narrowest = vessel.openings.front().radius;
    for (const Opening& opening : vessel.openings)
        narrowest = std::min(narrowest, opening.radius);
    if (!(spacing <= narrowest / 3.0)) {
        throw ConfigError(fmt::format(
            "{} = {:.6g} mm is too coarse for an opening of radius {:.6g} mm; a third of "
            "that at most",
            spacing_key, 1e3 * spacing, 1e3 * narrowest));
    }
    constexpr double most_voxels = 2e8;
    const double voxels = 2.0 * static_cast<double>(half_width) * area / (spacing * spacing);
    if (voxels > most_voxels) {
        throw ConfigError(fmt::format(
            "{} = {:.6g} mm would make a grid of {:.3g} voxels around a surface of {:.6g} "
            "mm2; {:.3g} at most",
            spacing_key, 1e3 * spacing, voxels, 1e6 * area, most_voxels));
    }
}

}  // namespace

void write_vessel_distance(const std::filesystem::path& path, const Vessel& vessel, double spacing,
                           const FileOrigin& origin)
{
    const TriangleMesh lumen = close_openings(vessel).mesh;
    require_usable(spacing, vessel, surface_area(lumen));
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    for (const Vec3& point : lumen.points) {
        const Eigen::Vector3f p = (point / vessel.unit.metres).cast<float>();
        points.emplace_back(p[0], p[1], p[2]);
    }
    for (const auto& [a, b, c] : lumen.triangles) {
        triangles.emplace_back(static_cast<openvdb::Index32>(a), static_cast<openvdb::Index32>(b),
                               static_cast<openvdb::Index32>(c));
    }
    openvdb::initialize();
    const double voxel = spacing / vessel.unit.metres;
    const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
    const auto grid = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points,
                                                                         triangles, half_width);
    grid->setName("vessel_distance");
    grid->setSaveFloatAsHalf(false);
    const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
    const openvdb::Coord first = box.min(), size = box.dim();
    add_vdb_labels<openvdb::TypedMetadata>(
        *grid, VdbLabels{.unit = vessel.unit,
                         .spacing = spacing,
                         .origin = spacing * Vec3(first.x(), first.y(), first.z()),
                         .dims = {size.x(), size.y(), size.z()},
                         .value_unit = vessel.unit.name,
                         .background = static_cast<double>(grid->background()),
                         .file = origin});
    try {
        openvdb::io::File file(path.string());
        file.write({grid});
        file.close();
    } catch (const openvdb::Exception& error) {
        throw IoError(fmt::format("{}: {}", path.string(), error.what()));
    }
    replace_vdb_mark(path);
}

}  // namespace braidzone
