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
/// 10.1109/TMI.2003.812261, search the Voronoi diagram; here the same functional is minimised on a
/// grid and then by moving the points continuously). The radius is the distance to the wall.
///
/// @param from, to  in the lumen or on an opening [m]
/// @throws GeometryError if a point lies outside the lumen or no path joins them
Polyline compute_centerline(const Vessel& vessel, const WallTree& wall, const Vec3& from,
                            const Vec3& to, const CenterlineOptions& options = {});

/// Fills in missing inscribed radii from the distance to the wall, and checks that every point lies
/// in the lumen.
/// @throws GeometryError naming the first point outside, and how many are
Polyline with_inscribed_radii(const Polyline& polyline, const WallTree& wall);

}  // namespace braidzone
