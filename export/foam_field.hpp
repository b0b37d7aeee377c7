#pragma once

#include "export/foam_mesh.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// What a volScalarField or volVectorField is called and measured in.
struct FoamField {
    std::string name;
    std::string value_type;  ///< "scalar" or "vector"
    std::string dimensions;  ///< e.g. "[0 -2 0 0 0 0 0]"
    std::string zero;        ///< the value on patches
};

/// The folder of a case's start fields, relative to the case: 0, or 0.orig if only that exists.
std::filesystem::path start_folder(const std::filesystem::path& foam_case);

/// Writes a field in ASCII. Patches hold `zero`; those that prescribe the type of every field's
/// boundary condition (cyclic, symmetry, ...) get their own.
/// @param folder  of the time, e.g. CASE/0
/// @param values  text of each cell's value
/// @throws IoError if it cannot be written
void write_foam_field(const std::filesystem::path& folder, const FoamField& field,
                      const std::vector<std::string>& values, const FoamMesh& mesh);

}  // namespace braidzone
