#pragma once

#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

#include <array>

namespace braidzone {

/// The block of cubes from which snappyHexMesh carves the lumen.
struct FoamBlock {
    Vec3 lower = Vec3::Zero();       ///< corner [m]
    double cell = 0.0;               ///< edge of a cube [m]
    std::array<int, 3> num_cells{};  ///< along x, y, z
    Vec3 upper() const { return lower + cell * Vec3(num_cells[0], num_cells[1], num_cells[2]); }
};

/// A point well inside the lumen, near an opening: of the points on the lines into the lumen from
/// the openings' centres, the one that is furthest from the wall and the openings' planes.
/// @throws GeometryError if no such point lies in the lumen
Vec3 point_in_lumen(const Vessel& vessel, const WallTree& wall);

/// The block around a vessel: at least one cell larger on every side (else a patch of the block's
/// boundary survives), and placed so that `inside` lies at a third of a cell along each axis. A
/// third is no multiple of 1/2^n: the point is on no face at any level of refinement.
FoamBlock block_around(const Vessel& vessel, const Vec3& inside, double cell);

}  // namespace braidzone
