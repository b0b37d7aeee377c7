#pragma once

#include "core/length_unit.hpp"
#include "porous/porous_field.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `field.vti`: the voxel fields as an image, names and units as in `field.vdb`. One VTK
/// cell for each voxel, so that ParaView shows voxels as they are; x runs fastest. Field data:
/// `length_unit` and, as strings `unit:<array>`, the unit of each array.
/// @throws IoError if the file cannot be written
void write_field_vti(const std::filesystem::path& path, const PorousField& field,
                     const LengthUnit& unit);

}  // namespace braidzone
