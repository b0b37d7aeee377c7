#pragma once

#include "porous/porous_field.hpp"

#include <algorithm>

namespace braidzone::test {

/// A small field of 4 x 5 x 6 voxels without any symmetry: distances and cell types that tell every
/// voxel from every other, and two touched voxels, (1, 2, 3) and (2, 0, 5), with values of their
/// own.
inline PorousField asymmetric_field()
{
    PorousField field;
    field.grid.origin = Vec3(1e-3, -2e-3, 3e-3);
    field.grid.spacing = 0.2e-3;
    field.grid.dims = {4, 5, 6};
    CubeMarks all(field.grid);
    all.mark({0, 0, 0}, {3, 4, 5});
    VoxelWallDistance& distance = field.wall_distance;
    distance.cubes = all.cubes();
    distance.of_cubes.assign(distance.cubes.num_cubes(), 0.0F);
    distance.of_voxels.assign(distance.cubes.num_held_voxels(), 0.0F);
    for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 4; ++i) {
                const auto index = static_cast<double>(field.grid.index(i, j, k));
                distance.of_voxels[held_place(distance.cubes, i, j, k)] =
                    static_cast<float>(1e-5 * (index - 40.0));
            }
        }
    }
    for (const std::size_t index : {field.grid.index(1, 2, 3), field.grid.index(2, 0, 5)})
        field.voxels.push_back(static_cast<std::int64_t>(index));
    field.void_fraction = {0.9, 0.8};
    field.surface_density = {5000.0, 6000.0};
    field.darcy_normal = {1.4e9, 2.5e9};
    field.forchheimer_normal = {6200.0, 7300.0};
    field.fluid = {1000.0, 4e-3};
    field.normal = {Vec3(0.6, 0.0, 0.8), Vec3(0.0, -1.0, 0.0)};
    field.tangential_ratio = {2.0, 0.5};
    return field;
}

/// The cell type that a voxel of `asymmetric_field` should have: in the lumen up to index 39,
/// porous where it is touched.
inline CellType expected_cell_type(const PorousField& field, std::size_t index)
{
    if (std::find(field.voxels.begin(), field.voxels.end(), static_cast<std::int64_t>(index)) !=
        field.voxels.end())
        return CellType::porous;
    return index < 40 ? CellType::fluid : CellType::outside;
}

}  // namespace braidzone::test
