#pragma once

#include "export/foam_cell_zones.hpp"
#include "export/foam_face_zones.hpp"
#include "export/foam_mesh.hpp"

#include <string>
#include <vector>

namespace braidzone {

constexpr const char* sac_cells_zone = "sac";

/// The sac in an OpenFOAM case: cell zone "sac", face zones "sac_neck" and "sac_wall"
/// (`foam_neck.hpp`), and the functions over them (`figure_functions`). Zones without faces are
/// left out.
struct FoamSacZones {
    std::vector<FoamCellZone> cells;
    std::vector<FoamFaceZone> faces;
    std::string functions;
};

/// @param sac  cell indices; nothing comes of an empty sac
FoamSacZones sac_zones(const std::vector<int>& sac, const FoamMesh& mesh);

}  // namespace braidzone
