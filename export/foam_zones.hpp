#pragma once

#include "export/foam_cell_zones.hpp"
#include "export/foam_porous_source.hpp"
#include "export/foam_resistance.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// Cells with one resistance: a Darcy-Forchheimer zone.
struct FoamZone {
    std::vector<int> cells;       ///< increasing
    double darcy = 0.0;           ///< volume-weighted mean along the normal [1/m^2]
    double forchheimer = 0.0;     ///< [1/m]
    Vec3 normal = Vec3::UnitX();  ///< volume- and resistance-weighted mean, unit
    double volume = 0.0;          ///< [m^3]
};

/// Groups cells by the direction of the normal and the logarithm of the resistance. Deterministic;
/// n and -n are the same direction. The sum of D times volume is kept.
///
/// Principal direction divisive partitioning (Boley 1998, doi 10.1023/A:1009740529316): the group
/// with the largest error is cut in two, across its widest direction through its mean, until there
/// are `most_zones` or no error is left. A cell is the point
///
///     (ln D, |1 - r| / max(1, r) n n^T)      weighted by D V,
///
/// r the tangential ratio: the distance of two cells is the relative difference of their resistance
/// tensors D (r I + (1 - r) n n^T), to first order. With r = 1 the normal does not count. Where
/// only the Forchheimer coefficient acts, it takes the place of D.
///
/// @param most_zones  upper limit; a solver's cost grows with zones times cells (64: not
/// noticeable,
///        256: +25 %)
std::vector<FoamZone> cluster(const CellResistance& resistance, const FoamMesh& mesh,
                              int most_zones = 64);

/// Name of zone i: "FD_0000", ...
std::string foam_zone_name(std::size_t zone);

/// Sum over the zones of D times the volume [m].
double resistance_integral(const std::vector<FoamZone>& zones);

/// The resistance of each zone as a source on its cells; e1 of its axes is the normal:
///
///     D = (D_n, r D_n, r D_n) along (e1, e2, e3), F alike
std::vector<FoamPorousSource> zone_sources(const std::vector<FoamZone>& zones,
                                           const TangentialRatio& ratio);

/// The cells of each zone under its name.
std::vector<FoamCellZone> named_zones(const std::vector<FoamZone>& zones);

}  // namespace braidzone
