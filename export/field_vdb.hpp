#pragma once

#include "core/length_unit.hpp"
#include "export/file_origin.hpp"
#include "porous/porous_field.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `field.vdb`: one sparse grid of single precision for each voxel field, with the transform
/// from index to the vessel's length unit; values in SI (half precision ends at 65504, Darcy
/// coefficients are about 1e9 1/m^2). Coordinate (i, j, k) is the field's voxel (i, j, k).
///
/// Grids: void_fraction (background 1), surface_density, darcy_normal, darcy_tangential,
/// forchheimer_normal (background 0) and normal (vector) with the voxels that the device touches
/// active; wall_distance [m, negative inside] with all of the field's voxels; cell_type (0 outside,
/// 1 fluid, 2 porous; as a float, because Debian's pyopenvdb reads no integer grids) with those of
/// the lumen. wall_distance is in metres whatever the coordinates' unit, so it is not marked as an
/// OpenVDB level set; `vessel_distance.hpp` writes one. All scalar grids are of the class fog
/// volume. Each grid's metadata holds what `add_vdb_labels` lists. Equal fields give equal
/// bytes.
/// @throws IoError if the file cannot be written; ConfigError if the voxels are too small for
/// OpenVDB
///         (`require_vdb_spacing`)
void write_field_vdb(const std::filesystem::path& path, const PorousField& field,
                     const LengthUnit& unit, const FileOrigin& origin = {});

}  // namespace braidzone
