#pragma once

#include "core/length_unit.hpp"
#include "porous/porous_field.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `field.vdb`: one sparse float grid for each voxel field, with the transform from index to
/// the vessel's length unit; values in SI (single precision: Darcy coefficients of 1e9 1/m^2 exceed
/// the half float of 65504). Grids: void_fraction (background 1), surface_density, darcy_normal,
/// darcy_tangential, forchheimer_normal (background 0), normal (vector), wall_distance [m, a level
/// set, negative inside], cell_type (int; 0 outside, 1 fluid, 2 porous). Each grid's metadata holds
/// its unit and the file's length unit.
/// @throws IoError if the file cannot be written
void write_field_vdb(const std::filesystem::path& path, const PorousField& field,
                     const LengthUnit& unit);

}  // namespace braidzone
