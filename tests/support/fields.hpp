#pragma once

#include "porous/porous_field.hpp"

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
    for (std::size_t index = 0; index < field.grid.num_voxels(); ++index) {
        const double distance = 1e-5 * (static_cast<double>(index) - 40.0);
        field.wall_distance.push_back(static_cast<float>(distance));
        field.cell_type.push_back(distance < 0.0 ? CellType::fluid : CellType::outside);
    }
    for (const std::size_t index : {field.grid.index(1, 2, 3), field.grid.index(2, 0, 5)}) {
        field.voxels.push_back(static_cast<std::int64_t>(index));
        field.cell_type[index] = CellType::porous;
    }
    field.void_fraction = {0.9, 0.8};
    field.surface_density = {5000.0, 6000.0};
    field.darcy_normal = {1.4e9, 2.5e9};
    field.darcy_tangential = {2.8e9, 5.0e9};
    field.forchheimer_normal = {6200.0, 7300.0};
    field.normal = {Vec3(0.6, 0.0, 0.8), Vec3(0.0, -1.0, 0.0)};
    return field;
}

}  // namespace braidzone::test
