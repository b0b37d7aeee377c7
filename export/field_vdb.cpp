#include "export/field_vdb.hpp"

#include "export/vdb_file.hpp"
#include "export/vdb_labels.hpp"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace braidzone {

namespace {

/// Coordinate of the voxel with that index.
openvdb::Coord coordinate(const VoxelGrid& grid, std::int64_t index)
{
    const auto& [i, j, k] = place_of(grid, index);
    return {i, j, k};
}

/// The field with what its grids say about it.
struct LabelledField {
    const PorousField& field;
    const LengthUnit& unit;
    const FileOrigin& file;
};

/// Names a grid, places it in the vessel's unit and states its units.
template <typename Grid>
typename Grid::Ptr make_grid(const std::string& name, const std::string& value_unit,
                             const typename Grid::ValueType& background,
                             const LabelledField& labelled)
{
    auto grid = Grid::create(background);
    grid->setName(name);
    grid->setSaveFloatAsHalf(false);
    const VoxelGrid& voxels = labelled.field.grid;
    const Vec3 origin = voxels.origin / labelled.unit.metres;
    auto transform =
        openvdb::math::Transform::createLinearTransform(voxels.spacing / labelled.unit.metres);
    transform->postTranslate({origin[0], origin[1], origin[2]});
    grid->setTransform(transform);
    VdbLabels labels{.unit = labelled.unit,
                     .spacing = voxels.spacing,
                     .origin = voxels.origin,
                     .dims = voxels.dims,
                     .value_unit = value_unit,
                     .file = labelled.file};
    if constexpr (std::is_same_v<Grid, openvdb::FloatGrid>) {
        labels.background = background;
        grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    }
    add_vdb_labels<openvdb::TypedMetadata>(*grid, labels);
    return grid;
}

openvdb::GridBase::Ptr sparse_grid(const std::string& name, const std::string& value_unit,
                                   float background, const std::vector<double>& values,
                                   const LabelledField& labelled)
{
    const PorousField& field = labelled.field;
    const auto grid = make_grid<openvdb::FloatGrid>(name, value_unit, background, labelled);
    auto accessor = grid->getAccessor();
    for (std::size_t i = 0; i < values.size(); ++i) {
        accessor.setValue(coordinate(field.grid, field.voxels[i]), static_cast<float>(values[i]));
    }
    return grid;
}

openvdb::GridBase::Ptr normal_grid(const LabelledField& labelled)
{
    const PorousField& field = labelled.field;
    const auto grid = make_grid<openvdb::Vec3SGrid>("normal", "1", openvdb::Vec3s(0.0F), labelled);
    grid->setVectorType(openvdb::VEC_COVARIANT_NORMALIZE);
    auto accessor = grid->getAccessor();
    for (std::size_t i = 0; i < field.normal.size(); ++i) {
        const Eigen::Vector3f normal = field.normal[i].cast<float>();
        accessor.setValue(coordinate(field.grid, field.voxels[i]),
                          {normal[0], normal[1], normal[2]});
    }
    return grid;
}

/// Calls visit(coordinate, place) for every voxel of the held cubes that lies in the grid.
template <typename Visit>
void for_each_held_voxel(const PorousField& field, Visit visit)
{
    const VoxelCubes& cubes = field.wall_distance.cubes;
    constexpr int edge = VoxelCubes::edge;
    for (const std::int32_t cube : cubes.held) {
        const auto& [a, b, c] = cubes.place_of(static_cast<std::size_t>(cube));
        for (int k = edge * c; k < std::min(edge * (c + 1), field.grid.dims[2]); ++k)
            for (int j = edge * b; j < std::min(edge * (b + 1), field.grid.dims[1]); ++j)
                for (int i = edge * a; i < std::min(edge * (a + 1), field.grid.dims[0]); ++i)
                    visit(openvdb::Coord(i, j, k), held_place(cubes, i, j, k));
    }
}

/// Calls visit(box, distance) for every cube that is one number, less what reaches over the grid: a
/// tile, which is what a leaf of OpenVDB's tree would hold.
template <typename Visit>
void for_each_tile(const PorousField& field, Visit visit)
{
    static_assert(VoxelCubes::edge == openvdb::FloatTree::LeafNodeType::DIM);
    constexpr int edge = VoxelCubes::edge;
    const VoxelCubes& cubes = field.wall_distance.cubes;
    const auto& [nx, ny, nz] = field.grid.dims;
    const openvdb::CoordBBox grid({0, 0, 0}, {nx - 1, ny - 1, nz - 1});
    for (std::size_t cube = 0; cube < cubes.num_cubes(); ++cube) {
        if (cubes.slots[cube] != VoxelCubes::not_held) continue;
        const auto& [a, b, c] = cubes.place_of(cube);
        auto box = openvdb::CoordBBox::createCube({edge * a, edge * b, edge * c}, edge);
        box.intersect(grid);
        visit(box, field.wall_distance.of_cubes[cube]);
    }
}

openvdb::GridBase::Ptr wall_distance_grid(const LabelledField& labelled)
{
    const PorousField& field = labelled.field;
    // Beyond the grid nothing is known; the largest distance keeps a contour of 0 from closing
    // along the grid's faces.
    float farthest = 0.0F;
    for (const auto* distances : {&field.wall_distance.of_voxels, &field.wall_distance.of_cubes})
        for (const float distance : *distances)
            farthest = std::max(farthest, std::abs(distance));
    const auto grid = make_grid<openvdb::FloatGrid>("wall_distance", "m", farthest, labelled);
    for_each_tile(field, [&](const openvdb::CoordBBox& box, float distance) {
        grid->sparseFill(box, distance, /*active=*/false);
    });
    auto accessor = grid->getAccessor();
    for_each_held_voxel(field, [&](const openvdb::Coord& voxel, std::size_t place) {
        accessor.setValue(voxel, field.wall_distance.of_voxels[place]);
    });
    return grid;
}

openvdb::GridBase::Ptr cell_type_grid(const LabelledField& labelled)
{
    const PorousField& field = labelled.field;
    const auto grid = make_grid<openvdb::FloatGrid>("cell_type", "1", 0.0F, labelled);
    constexpr auto fluid = static_cast<float>(CellType::fluid);
    for_each_tile(field, [&](const openvdb::CoordBBox& box, float distance) {
        if (distance < 0.0F) grid->sparseFill(box, fluid, /*active=*/true);
    });
    auto accessor = grid->getAccessor();
    for_each_held_voxel(field, [&](const openvdb::Coord& voxel, std::size_t place) {
        if (field.wall_distance.of_voxels[place] < 0.0F) accessor.setValue(voxel, fluid);
    });
    for (std::size_t i = 0; i < field.voxels.size(); ++i)
        accessor.setValue(coordinate(field.grid, field.voxels[i]),
                          static_cast<float>(cell_type(field, i)));
    return grid;
}

}  // namespace

void write_field_vdb(const std::filesystem::path& path, const PorousField& field,
                     const LengthUnit& unit, const FileOrigin& origin)
{
    require_vdb_spacing("grid.spacing", field.grid.spacing, unit);
    openvdb::initialize();
    const LabelledField labelled{field, unit, origin};
    const openvdb::GridPtrVec grids{
        sparse_grid("void_fraction", "1", 1.0F, field.void_fraction, labelled),
        sparse_grid("surface_density", "1/m", 0.0F, field.surface_density, labelled),
        sparse_grid("darcy_normal", "1/m^2", 0.0F, field.darcy_normal, labelled),
        sparse_grid("darcy_tangential", "1/m^2", 0.0F, darcy_tangential(field), labelled),
        sparse_grid("forchheimer_normal", "1/m", 0.0F, field.forchheimer_normal, labelled),
        sparse_grid("forchheimer_tangential", "1/m", 0.0F, forchheimer_tangential(field), labelled),
        sparse_grid("pressure_loss_linear", "Pa s/m", 0.0F, pressure_loss_linear(field), labelled),
        sparse_grid("pressure_loss_quadratic", "Pa s^2/m^2", 0.0F, pressure_loss_quadratic(field),
                    labelled),
        normal_grid(labelled),
        wall_distance_grid(labelled),
        cell_type_grid(labelled)};
    write_vdb_file<openvdb::io::File, openvdb::Exception>(path, grids);
}

}  // namespace braidzone
