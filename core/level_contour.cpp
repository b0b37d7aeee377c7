#include "core/level_contour.hpp"

#include <openvdb/openvdb.h>
#include <openvdb/tools/SignedFloodFill.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;

// Half width of the band of voxels with their own value [voxels].
constexpr double band = 3.0;

Vec3 voxel_centre(const openvdb::Coord& voxel)
{
    return {1.0 * voxel.x(), 1.0 * voxel.y(), 1.0 * voxel.z()};
}

/// The level on a grid of unit voxels, in voxels, filled in near its zero.
openvdb::FloatGrid::Ptr sample_near_zero(const std::function<double(const Vec3&)>& level,
                                         const Box& bounds, double voxel)
{
    const auto grid = openvdb::FloatGrid::create(static_cast<float>(band));
    const auto block_index = [voxel](double coordinate) {
        return static_cast<int>(std::floor(coordinate / (voxel * Leaf::DIM)));
    };
    const double half_diagonal = 0.5 * std::sqrt(3.0) * Leaf::DIM;
    const auto level_in_voxels = [&](const Vec3& place) { return level(voxel * place) / voxel; };
    const Vec3 lower = bounds.lower.array() - band * voxel;
    const Vec3 upper = bounds.upper.array() + band * voxel;
    for (int i = block_index(lower.x()); i <= block_index(upper.x()); ++i) {
        for (int j = block_index(lower.y()); j <= block_index(upper.y()); ++j) {
            for (int k = block_index(lower.z()); k <= block_index(upper.z()); ++k) {
                const openvdb::Coord origin(i * int{Leaf::DIM}, j * int{Leaf::DIM},
                                            k * int{Leaf::DIM});
                const Vec3 centre = voxel_centre(origin).array() + 0.5 * (Leaf::DIM - 1);
                if (std::abs(level_in_voxels(centre)) > half_diagonal + band) continue;
                Leaf* leaf = grid->tree().touchLeaf(origin);
                for (openvdb::Index n = 0; n < Leaf::SIZE; ++n) {
                    const Vec3 place = voxel_centre(leaf->offsetToGlobalCoord(n));
                    const double value = std::clamp(level_in_voxels(place), -band, band);
                    leaf->setValueOn(n, static_cast<float>(value));
                }
            }
        }
    }
    openvdb::tools::signedFloodFill(grid->tree(), false);
    return grid;
}

}  // namespace

TriangleMesh contour(const std::function<double(const Vec3&)>& level, const Box& bounds,
                     double voxel)
{
    openvdb::initialize();
    const auto grid = sample_near_zero(level, bounds, voxel);
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    std::vector<openvdb::Vec4I> quadrilaterals;
    openvdb::tools::volumeToMesh(*grid, points, triangles, quadrilaterals, 0.0, 0.0, true);

    TriangleMesh mesh;
    for (const openvdb::Vec3s& point : points) {
        mesh.points.push_back(voxel * Vec3(point.x(), point.y(), point.z()));
    }
    const auto add = [&mesh](openvdb::Index a, openvdb::Index b, openvdb::Index c) {
        mesh.triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    };
    for (const openvdb::Vec3I& triangle : triangles)
        add(triangle[0], triangle[1], triangle[2]);
    for (const openvdb::Vec4I& corner : quadrilaterals) {
        add(corner[0], corner[1], corner[2]);
        add(corner[0], corner[2], corner[3]);
    }
    if (enclosed_volume(mesh) < 0.0) {
        for (auto& triangle : mesh.triangles)
            std::swap(triangle[1], triangle[2]);
    }
    return mesh;
}

}  // namespace braidzone
