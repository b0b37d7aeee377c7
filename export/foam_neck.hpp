#pragma once

#include "export/foam_face_zones.hpp"
#include "export/foam_mesh.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// The neck on the mesh: the internal faces between the cells of the sac and all others, turned
/// into the sac. It lies where `find_sacs` ends the sac, on the sac's side of the porous layer.
/// @param name  of the zone
/// @param sac   cell indices
FoamFaceZone sac_neck(const std::string& name, const std::vector<int>& sac, const FoamMesh& mesh);

/// The faces of the sac's cells on patches of type `wall`.
FoamFaceZone sac_wall(const std::string& name, const std::vector<int>& sac, const FoamMesh& mesh);

}  // namespace braidzone
