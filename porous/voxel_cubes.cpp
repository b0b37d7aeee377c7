#include "porous/voxel_cubes.hpp"

#include <algorithm>

namespace braidzone {

CubeMarks::CubeMarks(const VoxelGrid& grid) : grid_(grid)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        cubes_.counts[axis] = (grid.dims[axis] + VoxelCubes::edge - 1) / VoxelCubes::edge;
    marks_.assign(cubes_.cube_index(0, 0, cubes_.counts[2]), 0);
}

void CubeMarks::mark(const std::array<int, 3>& first_voxel, const std::array<int, 3>& last_voxel)
{
    std::array<int, 3> first{}, last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first[axis] = std::max(first_voxel[axis], 0) / VoxelCubes::edge;
        const int last_inside = std::min(last_voxel[axis], grid_.dims[axis] - 1);
        if (last_inside < 0) return;
        last[axis] = last_inside / VoxelCubes::edge;
    }
    for (int c = first[2]; c <= last[2]; ++c)
        for (int b = first[1]; b <= last[1]; ++b)
            for (int a = first[0]; a <= last[0]; ++a)
                marks_[cubes_.cube_index(a, b, c)] = 1;
}

std::size_t CubeMarks::num_marked() const
{
    return static_cast<std::size_t>(std::count(marks_.begin(), marks_.end(), 1));
}

VoxelCubes CubeMarks::cubes() const
{
    VoxelCubes cubes = cubes_;
    cubes.slots.assign(marks_.size(), VoxelCubes::not_held);
    for (std::size_t cube = 0; cube < marks_.size(); ++cube) {
        if (!marks_[cube]) continue;
        cubes.slots[cube] = static_cast<std::int32_t>(cubes.held.size());
        cubes.held.push_back(static_cast<std::int32_t>(cube));
    }
    return cubes;
}

}  // namespace braidzone
