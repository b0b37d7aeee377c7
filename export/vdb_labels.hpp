#pragma once

#include "core/length_unit.hpp"
#include "core/vector.hpp"
#include "export/file_origin.hpp"

#include <array>
#include <string>

namespace braidzone {

/// The place of an OpenVDB grid in the vessel's file and what its metadata say.
struct VdbLabels {
    LengthUnit unit;             ///< of coordinates
    double spacing = 0.0;        ///< [m]
    Vec3 origin = Vec3::Zero();  ///< centre of the first voxel that the grid covers [m]
    std::array<int, 3> dims{};   ///< voxels that it covers
    std::string value_unit;      ///< "1" for a number without unit
    double background = 0.0;     ///< what the grid holds elsewhere
    FileOrigin file;
};

/// Adds a grid's metadata: strings `unit` (of the values), `length_unit`, `generator` and, if
/// known, `case_hash`; numbers `length_unit_m`, `dx_m` [m] and `background`; `dims` (three
/// integers) and `origin` (in the length unit).
/// @tparam Metadata  openvdb::TypedMetadata, given by the caller so that this header needs no
/// OpenVDB
template <template <typename> class Metadata, typename Grid>
void add_vdb_labels(Grid& grid, const VdbLabels& labels)
{
    using Vector = decltype(grid.voxelSize());
    using Integers = decltype(grid.evalActiveVoxelDim().asVec3i());
    const Vec3 origin = labels.origin / labels.unit.metres;
    const auto insert = [&]<typename Value>(const char* key, const Value& value) {
        grid.insertMeta(key, Metadata<Value>(value));
    };
    insert("unit", labels.value_unit);
    insert("length_unit", labels.unit.name);
    insert("length_unit_m", labels.unit.metres);
    insert("dx_m", labels.spacing);
    insert("dims", Integers(labels.dims[0], labels.dims[1], labels.dims[2]));
    insert("origin", Vector(origin[0], origin[1], origin[2]));
    insert("background", labels.background);
    insert("generator", labels.file.generator);
    if (!labels.file.case_hash.empty()) insert("case_hash", labels.file.case_hash);
}

/// Checks that OpenVDB takes voxels of that size: it refuses a transform whose determinant is below
/// 3e-15 (openvdb/math/Maps.h), voxels of less than 1.45e-5 of the length unit.
/// @param key      that the spacing comes from, for the message
/// @param spacing  [m]
/// @throws ConfigError if they are smaller
void require_vdb_spacing(const std::string& key, double spacing, const LengthUnit& unit);

}  // namespace braidzone
