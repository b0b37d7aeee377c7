#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

struct CenterlineOptions {
    double points_per_radius = 6.0;  ///< fineness of the search grid: smallest opening's radius / h
};

/// The centerline of a vessel between two points.
///
/// The path of least cost through the lumen, where the cost of a step is its length over a power
/// of the distance to the wall (Antiga, Ene-Iordache and Remuzzi 2003, doi
/// 10.1109/TMI.2003.812261, search the Voronoi diagram; here the functional is minimised on a grid,
/// see `least_cost_path`), then moved to the middle of the parent vessel's cross-sections
/// (`centred_path`). Neither follows the lumen into a sac. The radius is the distance to the wall.
///
/// @param from, to  in the lumen or on an opening [m]; they are the path's ends
/// @throws GeometryError if a point lies outside the lumen or no path joins them
Polyline compute_centerline(const Vessel& vessel, const WallTree& wall, const Vec3& from,
                            const Vec3& to, const CenterlineOptions& options = {});

/// Fills in missing inscribed radii from the distance to the wall, and checks that every point lies
/// in the lumen; the two ends may lie on an opening.
/// @throws GeometryError naming the first point outside, and how many are
Polyline with_inscribed_radii(const Polyline& polyline, const WallTree& wall);

}  // namespace braidzone
