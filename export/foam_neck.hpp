#pragma once

#include "export/foam_face_zones.hpp"
#include "export/foam_mesh.hpp"

#include <vector>

namespace braidzone {

constexpr const char* sac_neck_zone = "sac_neck";
constexpr const char* sac_wall_zone = "sac_wall";

/// The neck on the mesh: the internal faces between the cells of the sac and all others, turned
/// into the sac. It lies where `find_sac` ends the sac, on the sac's side of the porous layer.
/// @param sac  cell indices
FoamFaceZone sac_neck(const std::vector<int>& sac, const FoamMesh& mesh);

/// The faces of the sac's cells on patches of type `wall`.
FoamFaceZone sac_wall(const std::vector<int>& sac, const FoamMesh& mesh);

}  // namespace braidzone
