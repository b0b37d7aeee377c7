#include "export/foam_cell_zones.hpp"

#include "export/foam_zone_file.hpp"

namespace braidzone {

std::vector<FoamCellZone> read_cell_zones(const std::filesystem::path& foam_case)
{
    std::vector<FoamCellZone> zones;
    for (const FoamZoneEntry& entry : read_foam_zone_file(foam_case, "cellZones"))
        zones.push_back({entry.name, zone_list(entry, "cellLabels")});
    return zones;
}

void write_cell_zones(const std::filesystem::path& foam_case,
                      const std::vector<FoamCellZone>& zones)
{
    std::vector<FoamZoneEntry> entries;
    for (const FoamCellZone& zone : zones)
        entries.push_back({zone.name, {{"cellLabels", "label", zone.cells}}});
    write_foam_zone_file(foam_case, "cellZones", "cellZone", entries);
}

}  // namespace braidzone
