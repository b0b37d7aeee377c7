#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

struct CenterlineOptions {
    double points_per_radius = 6.0;  ///< fineness of the search grid: smallest opening's radius /
                                     ///< h; see `least_cost_path`
};

/// The centerline of a vessel between two points.
///
/// Along the line the integral of ds / R is least, R the radius of the inscribed sphere (Antiga,
/// Ene-Iordache and Remuzzi 2003, doi 10.1109/TMI.2003.812261, VMTK's definition), except where a
/// sac or a branch opens, whose larger spheres do not draw the line in. Found in three steps: the
/// way through the lumen on a grid (`least_cost_path`), the middle of the parent vessel's
/// cross-sections along it (`centred_path`), and the least integral beside that (`medial_path`). On
/// real carotids and siphons the length is within 0.5 % of that of VMTK's lines, both smoothed by
/// `resample`. The radius is the distance to the wall.
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
