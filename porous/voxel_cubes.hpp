#pragma once

#include "porous/voxel_grid.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace braidzone {

/// A sparse choice of a grid's voxels: cubes of 8 x 8 x 8 voxels, some of which are held. Values of
/// the held cubes' voxels lie cube after cube; the table of cubes costs one number for 512 voxels
/// of the grid. (Museth 2013, doi 10.1145/2487228.2487235, has the cubes as leaves of a tree.)
struct VoxelCubes {
    static constexpr int edge = 8;
    static constexpr std::size_t volume = 512;
    static constexpr std::int32_t not_held = -1;

    std::array<int, 3> counts{};  ///< cubes along each axis; the last may reach over the grid
    std::vector<std::int32_t>
        slots;                       ///< of each cube: its place among the held ones, or `not_held`
    std::vector<std::int32_t> held;  ///< cube of each slot, increasing

    std::size_t num_cubes() const { return slots.size(); }
    std::size_t num_held_voxels() const { return volume * held.size(); }

    std::size_t cube_of(int i, int j, int k) const
    {
        return cube_index(i / edge, j / edge, k / edge);
    }
    std::size_t cube_index(int a, int b, int c) const
    {
        return static_cast<std::size_t>(a) +
               static_cast<std::size_t>(counts[0]) *
                   (static_cast<std::size_t>(b) +
                    static_cast<std::size_t>(counts[1]) * static_cast<std::size_t>(c));
    }
    /// The place of a cube along each axis.
    std::array<int, 3> place_of(std::size_t cube) const
    {
        const auto nx = static_cast<std::size_t>(counts[0]);
        const auto ny = static_cast<std::size_t>(counts[1]);
        return {static_cast<int>(cube % nx), static_cast<int>(cube / nx % ny),
                static_cast<int>(cube / (nx * ny))};
    }
    /// Place of a voxel within its cube, 0 to 511.
    static std::size_t place_in_cube(int i, int j, int k)
    {
        return static_cast<std::size_t>(i % edge + edge * (j % edge + edge * (k % edge)));
    }
};

/// Place of a voxel of a held cube among the held voxels.
inline std::size_t held_place(const VoxelCubes& cubes, int i, int j, int k)
{
    const auto slot = static_cast<std::size_t>(cubes.slots[cubes.cube_of(i, j, k)]);
    return slot * VoxelCubes::volume + VoxelCubes::place_in_cube(i, j, k);
}

/// Which cubes of a grid to hold, as marks that can still be set.
class CubeMarks {
public:
    explicit CubeMarks(const VoxelGrid& grid);

    /// Marks every cube that a box of voxels touches; what lies outside the grid does not count.
    void mark(const std::array<int, 3>& first_voxel, const std::array<int, 3>& last_voxel);

    std::size_t num_marked() const;

    /// The cubes with the marked ones held.
    VoxelCubes cubes() const;

private:
    VoxelGrid grid_;
    VoxelCubes cubes_;
    std::vector<char> marks_;
};

}  // namespace braidzone
