#include "export/foam_sac_zones.hpp"

#include "export/foam_cell_zones.hpp"
#include "export/foam_face_zones.hpp"
#include "export/foam_figures.hpp"
#include "export/foam_neck.hpp"
#include "export/text_file.hpp"

namespace braidzone {

namespace {

constexpr const char* sac_cells_zone = "sac";

void write_sac_cells(const std::filesystem::path& foam_case, const std::vector<int>& sac)
{
    std::vector<FoamCellZone> zones = read_cell_zones(foam_case);
    std::erase_if(zones, [](const FoamCellZone& zone) { return zone.name == sac_cells_zone; });
    if (!sac.empty()) zones.push_back({sac_cells_zone, sac});
    write_cell_zones(foam_case, zones);
}

void write_sac_faces(const std::filesystem::path& foam_case,
                     const std::vector<FoamFaceZone>& of_sac)
{
    std::vector<FoamFaceZone> zones = read_face_zones(foam_case);
    const std::size_t num_before = zones.size();
    std::erase_if(zones, [](const FoamFaceZone& zone) {
        return zone.name == sac_neck_zone || zone.name == sac_wall_zone;
    });
    const bool removed = zones.size() < num_before;
    for (const FoamFaceZone& zone : of_sac) {
        if (!zone.faces.empty()) zones.push_back(zone);
    }
    if (removed || !of_sac.empty()) write_face_zones(foam_case, zones);
}

}  // namespace

std::vector<std::filesystem::path> write_sac_zones(const std::filesystem::path& foam_case,
                                                   const FoamMesh& mesh,
                                                   const std::vector<int>& sac)
{
    const auto functions = std::filesystem::path("system") / "fdFunctions";
    write_sac_cells(foam_case, sac);
    if (sac.empty()) {
        write_sac_faces(foam_case, {});
        std::filesystem::remove(foam_case / functions);
        return {};
    }
    const FoamFaceZone neck = sac_neck(sac, mesh), wall = sac_wall(sac, mesh);
    write_sac_faces(foam_case, {neck, wall});
    write_text_file(foam_case / functions,
                    figure_functions({!neck.faces.empty(), !wall.faces.empty()}));
    return {"constant/polyMesh/faceZones", functions};
}

}  // namespace braidzone
