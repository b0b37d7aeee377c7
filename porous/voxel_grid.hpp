#pragma once

#include "core/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace braidzone {

/// A regular grid of cubic voxels. Voxel (i, j, k) has its centre at
/// origin + spacing (i, j, k) and index i + nx (j + ny k).
struct VoxelGrid {
    Vec3 origin = Vec3::Zero();  ///< centre of voxel (0, 0, 0) [m]
    double spacing = 0.0;        ///< [m]
    std::array<int, 3> dims{};   ///< nx, ny, nz

    Vec3 centre(int i, int j, int k) const { return origin + spacing * Vec3(i, j, k); }
    std::size_t index(int i, int j, int k) const
    {
        return static_cast<std::size_t>(i) +
               static_cast<std::size_t>(dims[0]) *
                   (static_cast<std::size_t>(j) +
                    static_cast<std::size_t>(dims[1]) * static_cast<std::size_t>(k));
    }
    std::size_t num_voxels() const { return index(0, 0, dims[2]); }
};

/// The voxel (i, j, k) with that index.
inline std::array<int, 3> place_of(const VoxelGrid& grid, std::int64_t index)
{
    const std::int64_t nx = grid.dims[0], ny = grid.dims[1];
    return {static_cast<int>(index % nx), static_cast<int>(index / nx % ny),
            static_cast<int>(index / (nx * ny))};
}

}  // namespace braidzone
