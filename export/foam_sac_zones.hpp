#pragma once

#include "export/foam_cell_zones.hpp"
#include "export/foam_face_zones.hpp"
#include "export/foam_mesh.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// The sacs in an OpenFOAM case: for each a cell zone and the face zones of its neck and its wall
/// (`foam_neck.hpp`), named by `sac_names`, and the functions over them (`figure_functions`). Zones
/// without faces are left out.
struct FoamSacZones {
    std::vector<FoamCellZone> cells;
    std::vector<FoamFaceZone> faces;
    std::string functions;
};

/// @param sacs  as `find_sacs` returns them; nothing comes of none
FoamSacZones sac_zones(const std::vector<std::vector<int>>& sacs, const FoamMesh& mesh);

/// True for a name that a sac's zones may have: "sac", "sac_2", "sac_neck", "sac_2_wall", ...
bool is_sac_zone(const std::string& name);

}  // namespace braidzone
