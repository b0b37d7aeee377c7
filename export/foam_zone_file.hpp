#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// A list within a zone: "cellLabels", "faceLabels" or "flipMap".
struct FoamZoneList {
    std::string key;
    std::string type;  ///< "label" or "bool"
    std::vector<int> values;
};

/// A zone as it stands in a file of zones.
struct FoamZoneEntry {
    std::string name;
    std::vector<FoamZoneList> lists;
};

/// Reads constant/polyMesh/`file` (ASCII or binary, plain or gzipped); empty if there is none.
/// @param file  "cellZones" or "faceZones"
/// @throws IoError or InputError if it cannot be read
std::vector<FoamZoneEntry> read_foam_zone_file(const std::filesystem::path& foam_case,
                                               const std::string& file);

/// Writes constant/polyMesh/`file` in ASCII, in place of a plain or gzipped one.
/// @param type  "cellZone" or "faceZone"
/// @throws IoError if it cannot be written
void write_foam_zone_file(const std::filesystem::path& foam_case, const std::string& file,
                          const std::string& type, const std::vector<FoamZoneEntry>& zones);

/// The values of a zone's list; empty if it has no such list.
std::vector<int> zone_list(const FoamZoneEntry& zone, const std::string& key);

}  // namespace braidzone
