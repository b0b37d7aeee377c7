#pragma once

#include "core/fluid.hpp"
#include "export/foam_resistance.hpp"

#include <filesystem>
#include <optional>
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

/// Text of constant/fvOptions: an `explicitPorositySource` with DarcyForchheimer for each zone; e1
/// of its axes is the normal.
///
///     S = -(mu D + 1/2 rho |U| F) U,   D = (D_n, r D_n, r D_n) along (e1, e2, e3), F alike
///
/// The same text is read by openfoam.com (v1912: run; later: by its source) and by openfoam.org (8
/// to 14: by its source), there also as constant/fvModels.
///
/// With a shear-thinning fluid the solver's mu is that of the resolved flow, which knows nothing of
/// the shear between the wires. The sources then are of the model fixedCoeff, which has no mu:
///
///     S = -rho (alpha + beta |U|) U,   alpha = mu D / rho, beta = F / 2
///
/// In the sidewall case with Carreau-Yasuda blood mu in the zones would be 5.5 mPa s on average
/// (weighted by D) instead of 3.5, and the inflow through the neck a quarter less.
///
/// @param object  "fvOptions" or "fvModels"
/// @param fixed   the fluid whose viscosity the resistance keeps; none: the solver's own
std::string porous_sources(const std::vector<FoamZone>& zones, const TangentialRatio& ratio,
                           const std::string& object, const std::optional<Fluid>& fixed = {});

/// Writes the zones into constant/polyMesh/cellZones (those of the mesh are kept, FD_* of an
/// earlier call replaced) and constant/fvOptions (`explicitPorositySource`, DarcyForchheimer), with
/// a copy for openfoam.org's constant/fvModels.
/// @param fixed  see `porous_sources`
/// @throws IoError if a file cannot be read or written
void write_foam_zones(const std::filesystem::path& foam_case, const std::vector<FoamZone>& zones,
                      const TangentialRatio& ratio, const std::optional<Fluid>& fixed = {});

}  // namespace braidzone
