#pragma once

#include "export/foam_resistance.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Cells with one resistance: a Darcy-Forchheimer zone.
struct FoamZone {
    std::vector<int> cells;     ///< increasing
    double darcy = 0.0;         ///< volume-weighted mean along the normal [1/m^2]
    double forchheimer = 0.0;   ///< [1/m]
    Vec3 normal = Vec3::UnitX();///< volume- and resistance-weighted mean, unit
    double volume = 0.0;        ///< [m^3]
};

/// Groups cells by the direction of the normal and the logarithm of the resistance. Deterministic;
/// n and -n are the same direction. The sum of D times volume is kept.
/// @param most_zones  upper limit; a solver's cost grows with zones times cells (64: not noticeable,
///        256: +25 %)
std::vector<FoamZone> cluster(const CellResistance& resistance, const FoamMesh& mesh,
                              int most_zones = 64);

/// Writes the zones into constant/polyMesh/cellZones (those of the mesh are kept, FD_* of an earlier
/// call replaced) and constant/fvOptions (`explicitPorositySource`, DarcyForchheimer), with a copy
/// for openfoam.org's constant/fvModels.
/// @throws IoError if a file cannot be read or written
void write_foam_zones(const std::filesystem::path& foam_case, const std::vector<FoamZone>& zones,
                      double tangential_ratio);

}  // namespace braidzone
