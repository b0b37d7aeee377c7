#pragma once

#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

/// The path through the lumen that minimises, on a cubic grid with 26 neighbours (Hart,
/// Nilsson and Raphael 1968, doi 10.1109/TSSC.1968.300136),
///
///     integral ds / min(d, cap)^2,    d the distance to the wall.
///
/// Without the cap a sac, being wide, would attract the path; with the parent vessel's radius as
/// cap all of the sac is as good as the parent's axis, and the shorter way along the parent wins.
///
/// @param from, to  in the lumen [m]
/// @param cap       [m]
/// @param spacing   of the grid [m]
/// @return the grid's points from `from` to `to`, both included; empty if no path joins them
std::vector<Vec3> least_cost_path(const WallTree& wall, const Vec3& from, const Vec3& to,
                                  double cap, double spacing);

}  // namespace braidzone
