#pragma once

#include "core/opening.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

/// What lies behind a rim.
struct LumenBehind {
    bool is_tube = false;  ///< the wall leads inwards from the rim; else the rim is a hole
    double radius = 0.0;   ///< of the lumen behind: `first_largest_distance` [m]
};

/// Tells the end of a tube, however small, from a hole in the wall.
///
/// From a point p behind the rim's middle, at a depth d along its inward normal, the nearest wall
/// is at the distance w and the rim at q. Under a hole, in flat or hollow wall, the nearest wall is
/// the rim itself: w = q. In a tube of radius r it lies beside p: w / q = r / sqrt(r^2 + d^2), 0.71
/// at d = r. In a stub of length h it is sqrt((d - h)^2 + r^2) / sqrt(d^2 + r^2), below 0.9 at
/// d = r if h is more than 0.21 r. So the rim belongs to a tube if w < 0.9 q at one of the depths
/// 0.5, 1, 1.5 and 2 r, r = sqrt(A / pi), and the nearest wall there is neither ahead nor behind:
/// not within 26 degrees of the normal, where the opposite wall is, or a limb outside that touches.
///
/// A tube that is cut obliquely, up to 60 degrees, or whose rim is jagged, is a tube; a branch cut
/// off flush with its parent is a hole, as nothing tells the two apart.
///
/// @param opening  a rim of the wall
/// @param wall     without any caps over the rim
LumenBehind lumen_behind(const Opening& opening, const TriangleMesh& mesh, const WallTree& wall);

/// The distance to the wall where it is largest first, on a straight way into the lumen [m]: it
/// ends where the distance has fallen by 5 %, or 1.5 of the largest distance from the start.
/// @param start    on the wall, or in a rim
/// @param inwards  unit
/// @param step     [m]
double first_largest_distance(const Vec3& start, const Vec3& inwards, double step,
                              const WallTree& wall);

}  // namespace braidzone
