#pragma once

#include <filesystem>
#include <optional>

namespace braidzone {

/// The constant kinematic viscosity nu of an OpenFOAM case [m^2/s], from
/// constant/transportProperties or, as openfoam.org has it since version 9,
/// constant/physicalProperties. Absent if there is no such file, if the fluid is not Newtonian
/// (`transportModel` or `viscosityModel` other than Newtonian or constant), or if nu is not a plain
/// number.
std::optional<double> case_viscosity(const std::filesystem::path& foam_case);

}  // namespace braidzone
