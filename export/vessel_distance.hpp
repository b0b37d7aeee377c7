#pragma once

#include "core/vessel.hpp"
#include "export/file_origin.hpp"

#include <filesystem>

namespace braidzone {

/// Writes the signed distance to the surface of the closed lumen, wall and caps, as an OpenVDB
/// level set `vessel_distance`: in the vessel's length unit like its coordinates, negative inside,
/// exact within three voxels of the surface and +-3 voxels beyond (OpenVDB's meshToLevelSet). Voxel
/// centres lie on multiples of the spacing, as those of the voxel fields.
///
/// `wall_distance` of the voxel fields is another thing: it is in metres, only around the device,
/// and the caps over the openings are no wall there.
///
/// @param spacing  edge of a voxel [m]; a third of the narrowest opening's radius at most
/// @throws ConfigError if the spacing is too coarse, too small for OpenVDB (`require_vdb_spacing`),
///         or the grid would exceed 2e8 voxels; IoError if the file cannot be written
void write_vessel_distance(const std::filesystem::path& path, const Vessel& vessel, double spacing,
                           const FileOrigin& origin = {});

}  // namespace braidzone
