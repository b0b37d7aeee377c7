#include "export/foam_sac_zones.hpp"

#include "export/foam_figures.hpp"
#include "export/foam_neck.hpp"

namespace braidzone {

FoamSacZones sac_zones(const std::vector<int>& sac, const FoamMesh& mesh)
{
    if (sac.empty()) return {};
    FoamSacZones zones;
    zones.cells = {{sac_cells_zone, sac}};
    const FoamFaceZone neck = sac_neck(sac, mesh), wall = sac_wall(sac, mesh);
    for (const FoamFaceZone& zone : {neck, wall})
        if (!zone.faces.empty()) zones.faces.push_back(zone);
    zones.functions = figure_functions({!neck.faces.empty(), !wall.faces.empty()});
    return zones;
}

}  // namespace braidzone
