#pragma once

#include "core/vector.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// A boundary patch of an OpenFOAM mesh.
struct FoamPatch {
    std::string name;
    std::string type;
    int start_face = 0;
    int num_faces = 0;
};

/// A polyhedral mesh as OpenFOAM stores it, in metres.
struct FoamMesh {
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;  ///< points of each face; internal faces first
    std::vector<int> owner;               ///< cell of each face
    std::vector<int> neighbour;           ///< other cell of each internal face
    std::vector<FoamPatch> patches;
    std::vector<Vec3> cell_centres;    ///< [m]
    std::vector<double> cell_volumes;  ///< [m^3]
    int num_cells() const { return static_cast<int>(cell_volumes.size()); }
};

/// Number of cells: one more than the largest index among owners and neighbours (a cell may own no
/// face).
int count_cells(const FoamMesh& mesh);

/// Reads constant/polyMesh of an OpenFOAM case: ASCII or binary, plain or gzipped, 32- or 64-bit
/// labels and scalars by the header's `arch`.
///
/// Cell centres and volumes by OpenFOAM's own formulas (primitiveMesh: pyramids from the average of
/// the face centres), so that they agree with the solver's to round-off.
///
/// @param foam_case  the folder that holds constant/polyMesh
/// @throws IoError if a file is missing or unreadable; InputError for a decomposed case (processor*
///         folders without constant/polyMesh) or what is no mesh of closed cells
///         (`require_closed_mesh`)
FoamMesh read_foam_mesh(const std::filesystem::path& foam_case);

}  // namespace braidzone
