#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// A named set of cells of an OpenFOAM mesh.
struct FoamCellZone {
    std::string name;
    std::vector<int> cells;
};

/// Reads constant/polyMesh/cellZones (ASCII or binary, plain or gzipped); empty if there is none.
/// @throws IoError or InputError if it cannot be read
std::vector<FoamCellZone> read_cell_zones(const std::filesystem::path& foam_case);

/// Writes constant/polyMesh/cellZones in ASCII, in place of a plain or gzipped one.
/// @throws IoError if it cannot be written
void write_cell_zones(const std::filesystem::path& foam_case,
                      const std::vector<FoamCellZone>& zones);

}  // namespace braidzone
