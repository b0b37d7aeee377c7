#include "export/field_vdb.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace braidzone {

namespace {

/// Coordinate of the voxel with that index.
openvdb::Coord coordinate(const VoxelGrid& grid, std::int64_t index)
{
    const std::int64_t nx = grid.dims[0], ny = grid.dims[1];
    return {static_cast<int>(index % nx), static_cast<int>(index / nx % ny),
            static_cast<int>(index / (nx * ny))};
}

/// Names a grid, places it in the vessel's unit and states its units.
template <typename Grid>
typename Grid::Ptr make_grid(const std::string& name, const std::string& value_unit,
                             const typename Grid::ValueType& background, const PorousField& field,
                             const LengthUnit& unit)
{
    auto grid = Grid::create(background);
    grid->setName(name);
    const double spacing = field.grid.spacing / unit.metres;
    const Vec3 origin = field.grid.origin / unit.metres;
    auto transform = openvdb::math::Transform::createLinearTransform(spacing);
    transform->postTranslate({origin[0], origin[1], origin[2]});
    grid->setTransform(transform);
    grid->insertMeta("unit", openvdb::StringMetadata(value_unit));
    grid->insertMeta("length_unit", openvdb::StringMetadata(unit.name));
    return grid;
}

openvdb::GridBase::Ptr sparse_grid(const std::string& name, const std::string& value_unit,
                                   float background, const std::vector<double>& values,
                                   const PorousField& field, const LengthUnit& unit)
{
    const auto grid = make_grid<openvdb::FloatGrid>(name, value_unit, background, field, unit);
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    auto accessor = grid->getAccessor();
    for (std::size_t i = 0; i < values.size(); ++i) {
        accessor.setValue(coordinate(field.grid, field.voxels[i]), static_cast<float>(values[i]));
    }
    return grid;
}

openvdb::GridBase::Ptr normal_grid(const PorousField& field, const LengthUnit& unit)
{
    const auto grid =
        make_grid<openvdb::Vec3SGrid>("normal", "1", openvdb::Vec3s(0.0F), field, unit);
    grid->setVectorType(openvdb::VEC_COVARIANT_NORMALIZE);
    auto accessor = grid->getAccessor();
    for (std::size_t i = 0; i < field.normal.size(); ++i) {
        const Eigen::Vector3f normal = field.normal[i].cast<float>();
        accessor.setValue(coordinate(field.grid, field.voxels[i]),
                          {normal[0], normal[1], normal[2]});
    }
    return grid;
}

openvdb::GridBase::Ptr wall_distance_grid(const PorousField& field, const LengthUnit& unit)
{
    // Beyond the grid nothing is known; the largest distance keeps a contour of 0 from closing
    // along the grid's faces.
    float farthest = 0.0F;
    for (const float distance : field.wall_distance) {
        farthest = std::max(farthest, std::abs(distance));
    }
    const auto grid = make_grid<openvdb::FloatGrid>("wall_distance", "m", farthest, field, unit);
    auto accessor = grid->getAccessor();
    for (std::size_t i = 0; i < field.wall_distance.size(); ++i) {
        accessor.setValue(coordinate(field.grid, static_cast<std::int64_t>(i)),
                          field.wall_distance[i]);
    }
    return grid;
}

openvdb::GridBase::Ptr cell_type_grid(const PorousField& field, const LengthUnit& unit)
{
    const auto grid = make_grid<openvdb::FloatGrid>("cell_type", "1", 0.0F, field, unit);
    auto accessor = grid->getAccessor();
    for (std::size_t i = 0; i < field.cell_type.size(); ++i) {
        if (field.cell_type[i] != CellType::outside) {
            accessor.setValue(coordinate(field.grid, static_cast<std::int64_t>(i)),
                              static_cast<float>(field.cell_type[i]));
        }
    }
    return grid;
}

/// 64-bit FNV-1a hash.
std::uint64_t hash(const std::string& bytes, std::uint64_t basis)
{
    for (const char byte : bytes) {
        basis = (basis ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return basis;
}

/// OpenVDB marks each file with a random UUID (after 8 bytes of magic number, 4 of file version, 8
/// of library version and 1 that says whether there are offsets). It is replaced by one made from
/// the content, so that equal fields give equal files.
void replace_random_mark(const std::filesystem::path& path)
{
    constexpr std::streamoff mark_offset = 21;
    constexpr std::size_t mark_size = 36;
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    content.erase(mark_offset, mark_size);
    const std::uint64_t high = hash(content, 0xcbf29ce484222325U);
    const std::uint64_t low = hash(content, high);
    // Version 8 (given by the application), variant 2, as RFC 9562 has it.
    const std::string mark =
        fmt::format("{:08x}-{:04x}-8{:03x}-a{:03x}-{:012x}", high >> 32U, high >> 16U & 0xffffU,
                    high & 0xfffU, low >> 52U, low & 0xffffffffffffU);
    file.clear();
    file.seekp(mark_offset);
    file.write(mark.data(), static_cast<std::streamsize>(mark.size()));
    file.close();
    if (!file) throw IoError(fmt::format("{}: cannot be written", path.string()));
}

}  // namespace

void write_field_vdb(const std::filesystem::path& path, const PorousField& field,
                     const LengthUnit& unit)
{
    openvdb::initialize();
    const openvdb::GridPtrVec grids{
        sparse_grid("void_fraction", "1", 1.0F, field.void_fraction, field, unit),
        sparse_grid("surface_density", "1/m", 0.0F, field.surface_density, field, unit),
        sparse_grid("darcy_normal", "1/m^2", 0.0F, field.darcy_normal, field, unit),
        sparse_grid("darcy_tangential", "1/m^2", 0.0F, field.darcy_tangential, field, unit),
        sparse_grid("forchheimer_normal", "1/m", 0.0F, field.forchheimer_normal, field, unit),
        normal_grid(field, unit),
        wall_distance_grid(field, unit),
        cell_type_grid(field, unit)};
    try {
        openvdb::io::File file(path.string());
        file.write(grids);
        file.close();
    } catch (const openvdb::Exception& error) {
        throw IoError(fmt::format("{}: {}", path.string(), error.what()));
    }
    replace_random_mark(path);
}

}  // namespace braidzone
