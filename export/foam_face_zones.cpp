#include "export/foam_face_zones.hpp"

#include "export/foam_zone_file.hpp"

namespace braidzone {

std::vector<FoamFaceZone> read_face_zones(const std::filesystem::path& foam_case)
{
    std::vector<FoamFaceZone> zones;
    for (const FoamZoneEntry& entry : read_foam_zone_file(foam_case, "faceZones"))
        zones.push_back({entry.name, zone_list(entry, "faceLabels"), zone_list(entry, "flipMap")});
    return zones;
}

void write_face_zones(const std::filesystem::path& foam_case,
                      const std::vector<FoamFaceZone>& zones)
{
    std::vector<FoamZoneEntry> entries;
    for (const FoamFaceZone& zone : zones)
        entries.push_back(
            {zone.name, {{"faceLabels", "label", zone.faces}, {"flipMap", "bool", zone.flipped}}});
    write_foam_zone_file(foam_case, "faceZones", "faceZone", entries);
}

}  // namespace braidzone
