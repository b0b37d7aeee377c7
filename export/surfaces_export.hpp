#pragma once

#include "core/vessel.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"
#include "export/file_origin.hpp"
#include "export/wire_tubes.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// What can be written as a surface.
enum class SurfacePart { vessel, device, wires, distance };

/// Its name in the case file; the name at a place is that of the part with that number.
std::vector<std::string> surface_part_names();

struct SurfacesOptions {
    std::vector<SurfacePart> parts = {SurfacePart::vessel, SurfacePart::device, SurfacePart::wires,
                                      SurfacePart::distance};
    WireTubeOptions wires;
    double shell_thickness = 0.0;   ///< of the device as a solid [m]; 0: two of its wire diameters
    double distance_spacing = 0.0;  ///< voxels of the signed distance [m]; > 0 if it is written

    bool has(SurfacePart part) const;
};

/// Most triangles of one file: a binary STL of 1 GB.
constexpr std::size_t most_surface_triangles = 20'000'000;

/// Checks that the wires of a device can be written as asked for.
/// @throws ConfigError if the pattern does not close around the braid, or the tubes would have more
///         than `most_surface_triangles`
void require_possible_wires(const FlowDiverter& device, const SurfacesOptions& options);

/// A device to write, the first one before one that lies in it.
struct SurfaceDevice {
    std::string prefix;  ///< of its files' names
    const Deployment& deployment;
    double wire_diameter = 0.0;  ///< [m]
};

/// Writes closed surfaces for programs that take solids: binary STL in the vessel's length unit,
/// normals outwards.
///
/// - vessel.stl: the lumen, its openings closed by flat caps
/// - device.stl: the device's skin as a thin solid (`device_shell.hpp`)
/// - wires.stl: its wires, each a closed tube (`wire_tubes.hpp`)
/// - vessel_distance.vdb: signed distance to vessel.stl (`vessel_distance.hpp`)
/// - surfaces.json: unit, openings, triangles, areas, volumes and gaps; README.md: who reads what
///
/// Wires keep a twentieth of their diameter from the wall and the solid a tenth of its thickness, a
/// second device as much from the first.
///
/// @param wall  of the vessel
/// @return sentences about what is not as it should be: surfaces that cross themselves or the
///         wall, wires that overlap; they are in surfaces.json, too
/// @throws IoError if a file cannot be written; what `write_vessel_distance` throws
std::vector<std::string> write_surfaces(const std::filesystem::path& folder, const Vessel& vessel,
                                        const WallTree& wall,
                                        const std::vector<SurfaceDevice>& devices,
                                        const SurfacesOptions& options,
                                        const FileOrigin& origin = {});

}  // namespace braidzone
