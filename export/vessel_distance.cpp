#include "export/vessel_distance.hpp"

#include "core/error.hpp"
#include "core/wall_tree.hpp"
#include "export/vdb_file.hpp"
#include "export/vdb_labels.hpp"

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/ChangeBackground.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/Prune.h>
#include <openvdb/tree/LeafManager.h>

#include <algorithm>
#include <cmath>
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

/// A level set of the surface by meshToVolume, with a band that is wider by one voxel: its signs
/// are right, its distances are not the shortest ones everywhere (off by a third of a voxel beside
/// the edges of caps).
openvdb::FloatGrid::Ptr rough_level_set(const TriangleMesh& surface,
                                        const openvdb::math::Transform& transform, double spacing)
{
    std::vector<openvdb::Vec3s> points;  // in voxels
    std::vector<openvdb::Vec3I> triangles;
    for (const Vec3& point : surface.points) {
        const Eigen::Vector3f p = (point / spacing).cast<float>();
        points.emplace_back(p[0], p[1], p[2]);
    }
    for (const auto& [a, b, c] : surface.triangles) {
        triangles.emplace_back(static_cast<openvdb::Index32>(a), static_cast<openvdb::Index32>(b),
                               static_cast<openvdb::Index32>(c));
    }
    const openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I> mesh(
        points, triangles);
    constexpr float band = half_width + 1.0F;
    return openvdb::tools::meshToVolume<openvdb::FloatGrid>(
        mesh, transform, band, band, openvdb::tools::DISABLE_RENORMALIZATION);
}

/// Gives the voxels of a level set their distance from the surface; what is beyond the band becomes
/// inside or outside.
void make_exact(openvdb::FloatGrid& grid, const TriangleMesh& surface, double spacing)
{
    Vessel closed;
    closed.wall = surface;
    const WallTree tree(closed);
    const double voxel = grid.voxelSize()[0];
    const float band = half_width * static_cast<float>(voxel);
    openvdb::tree::LeafManager<openvdb::FloatTree> leaves(grid.tree());
    leaves.foreach ([&](openvdb::FloatTree::LeafNodeType& leaf, std::size_t) {
        for (auto value = leaf.beginValueOn(); value; ++value) {
            const openvdb::Coord at = value.getCoord();
            const Vec3 point = spacing * Vec3(at.x(), at.y(), at.z());
            const double distance = tree.nearest(point).distance / spacing * voxel;
            const float within = std::min(static_cast<float>(distance), band);
            value.setValue(std::copysign(within, *value));
            value.setValueOn(within < band);
        }
    });
    openvdb::tools::changeLevelSetBackground(grid.tree(), band);
    openvdb::tools::pruneLevelSet(grid.tree());
}

}  // namespace

void write_vessel_distance(const std::filesystem::path& path, const Vessel& vessel, double spacing,
                           const FileOrigin& origin)
{
    const TriangleMesh lumen = close_openings(vessel).mesh;
    require_usable(spacing, vessel, surface_area(lumen));
    openvdb::initialize();
    const auto transform =
        openvdb::math::Transform::createLinearTransform(spacing / vessel.unit.metres);
    const openvdb::FloatGrid::Ptr grid = rough_level_set(lumen, *transform, spacing);
    make_exact(*grid, lumen, spacing);
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
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
    write_vdb_file<openvdb::io::File, openvdb::Exception>(path, openvdb::GridCPtrVec{grid});
}

}  // namespace braidzone
