#pragma once

#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

/// The path through the lumen that minimises, on cubic grids with 26 neighbours (A* search: Hart,
/// Nilsson and Raphael 1968, doi 10.1109/TSSC.1968.300136),
///
///     integral ds / min(d, cap)^2,    d the distance to the wall.
///
/// Without the cap a sac, being wide, would attract the path; with the parent vessel's radius as
/// cap all of the sac is as good as the parent's axis, and the shorter way along the parent wins.
///
/// The grid is as coarse as the lumen is wide: along each axis a step is 0.2 to 0.4 of the
/// lumen's depth, which is d in the middle and, beside the wall, the distance to which a ball that
/// touches the wall there grows. So the cost of the search grows with the lumen's length over its
/// radius, not with its volume over the narrowest opening's. A step that leaves the ball of radius
/// d is tested against the wall: none passes it, however near another lumen lies behind it. The
/// search begins at the narrower end. Distances in it are 5 % exact.
///
/// @param from, to  in the lumen [m]
/// @param cap       [m]; > 0
/// @param spacing   twice the least step [m]; > 0; a lumen of less than a quarter of it in
///                  radius, and longer than a step, is no way
/// @return points from `from` to `to`, both included, the segments between them in the lumen; empty
///         if no path joins them
std::vector<Vec3> least_cost_path(const WallTree& wall, const Vec3& from, const Vec3& to,
                                  double cap, double spacing);

}  // namespace braidzone
