#pragma once

#include "core/vector.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// A Darcy-Forchheimer source on a cell zone:
///
///     S = -(mu D + 1/2 rho |U| F) U,   D, F diagonal along (e1, e2, e3)
struct FoamPorousSource {
    std::string name;
    std::string cell_zone;
    Vec3 darcy = Vec3::Zero();        ///< along the axes [1/m^2]
    Vec3 forchheimer = Vec3::Zero();  ///< along the axes [1/m]
    Vec3 e1 = Vec3::UnitX();          ///< unit
    /// Field that D is multiplied with in place of the fluid's kinematic viscosity; empty: that.
    std::string viscosity_field = {};
    /// Kinematic viscosity that the resistance keeps whatever the fluid's [m^2/s]. A shear-thinning
    /// fluid's is that of the resolved flow, which knows nothing of the shear between the wires: in
    /// the sidewall case with Carreau-Yasuda blood 5.5 mPa s on average (weighted by D) instead of
    /// 3.5, and a quarter less inflow through the neck.
    /// The source then is of the model fixedCoeff, which has no viscosity:
    ///
    ///     S = -rho (alpha + beta |U|) U,   alpha = nu D, beta = F / 2
    std::optional<double> viscosity = {};
};

/// Text of constant/fdPorosity: an `explicitPorositySource` with DarcyForchheimer (or
/// fixedCoeff) for each source.
///
/// The same text is read by openfoam.com (v1912: run; later: by its source) and by openfoam.org (8
/// to 14: by its source), there also from constant/fvModels.
std::string porous_sources(const std::vector<FoamPorousSource>& sources);

/// Writes constant/fdPorosity and sees to it that constant/fvOptions includes it, and
/// constant/fvModels, openfoam.org's name for the same. A file that a case has already keeps what
/// it holds and gets the line `#include "fdPorosity"` at its end; system/fvOptions too, which
/// OpenFOAM reads where constant/fvOptions is missing.
/// @return the files written or changed, relative to the case
/// @throws IoError if a file cannot be read or written
std::vector<std::filesystem::path> write_porous_sources(
    const std::filesystem::path& foam_case, const std::vector<FoamPorousSource>& sources);

}  // namespace braidzone
