#pragma once

#include "export/foam_block.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// What the meshing dictionaries need to know.
struct FoamMeshingPlan {
    FoamBlock block;
    Vec3 inside = Vec3::Zero();         ///< point in the lumen [m]
    std::vector<std::string> openings;  ///< patch names
    int surface_level = 1;              ///< halvings of the block's cells at the wall
    int device_level = 2;               ///< halvings around the device
    /// Distance from the device within which cells are refined [m]; 0: no device to refine around.
    double device_distance = 0.0;
    bool follows_device = false;  ///< faces of the mesh lie on the device, as baffles need it
};

std::string block_mesh_dict(const FoamMeshingPlan& plan);
std::string surface_feature_extract_dict();
std::string snappy_hex_mesh_dict(const FoamMeshingPlan& plan);

}  // namespace braidzone
