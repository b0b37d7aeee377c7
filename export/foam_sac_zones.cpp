#include "export/foam_sac_zones.hpp"

#include "export/foam_figures.hpp"
#include "export/foam_neck.hpp"

#include <regex>

namespace braidzone {

FoamSacZones sac_zones(const std::vector<std::vector<int>>& sacs, const FoamMesh& mesh)
{
    FoamSacZones zones;
    std::vector<SacFigures> figures;
    for (std::size_t number = 0; number < sacs.size(); ++number) {
        const SacNames names = sac_names(number);
        zones.cells.push_back({names.cells, sacs[number]});
        const FoamFaceZone neck = sac_neck(names.neck, sacs[number], mesh);
        const FoamFaceZone wall = sac_wall(names.wall, sacs[number], mesh);
        for (const FoamFaceZone& zone : {neck, wall})
            if (!zone.faces.empty()) zones.faces.push_back(zone);
        figures.push_back({names, !neck.faces.empty(), !wall.faces.empty()});
    }
    zones.functions = figure_functions(figures);
    return zones;
}

bool is_sac_zone(const std::string& name)
{
    static const std::regex pattern("sac(_[0-9]+)?(_neck|_wall)?");
    return std::regex_match(name, pattern);
}

}  // namespace braidzone
