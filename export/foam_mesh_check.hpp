#pragma once

#include "export/foam_mesh.hpp"

#include <string>

namespace braidzone {

/// Refuses what is no mesh of closed cells, before anything is sized by its labels:
///
/// - one owner for each face, no more neighbours than faces; three points or more a face, all in
///   the list of points, which are finite
/// - cells numbered from 0, at most half as many as there are faces (a face has two sides and a
///   cell four faces or more), each with four faces or more
/// - the owner of an internal face has the smaller number of its two cells, as in every mesh that
///   OpenFOAM writes
/// - each cell is closed: |sum S| <= 1e-6 sum |S| over the area vectors S of its faces (the
///   threshold of OpenFOAM's checkMesh)
/// - every face on the boundary belongs to one patch, and no other face to any
///
/// @param folder  of the mesh, for the message
/// @throws InputError with the face, cell or patch concerned
void require_closed_mesh(const FoamMesh& mesh, const std::string& folder);

}  // namespace braidzone
