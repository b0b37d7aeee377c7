#pragma once

#include "export/foam_mesh.hpp"

namespace braidzone {

/// Fills in `cell_centres` and `cell_volumes` from points and faces by the formulas of OpenFOAM's
/// primitiveMesh (primitiveMeshFaceCentresAndAreas.C, primitiveMeshCellCentresAndVols.C):
///
///     face:  triangles around the mean of its points; area vector = their sum, centre = their
///            area-weighted mean
///     cell:  pyramids from the mean of its face centres; volume = their sum, centre = their
///            volume-weighted mean
void compute_cell_geometry(FoamMesh& mesh);

/// Area vector of a face by the same formula, out of its owner [m^2].
Vec3 face_area(const FoamMesh& mesh, std::size_t face);

}  // namespace braidzone
