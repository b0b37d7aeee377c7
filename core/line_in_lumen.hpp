#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

/// A part of a line that passed through the wall and was laid anew.
struct RecentredPart {
    Vec3 place = Vec3::Zero();   ///< where it passed through the wall first [m]
    double largest_shift = 0.0;  ///< of the new path from the line's curve [m]
    double share = 0.0;          ///< the largest shift over the distance to the wall there
};

/// A line whose path, not its points alone, lies in the lumen.
struct LineInLumen {
    Polyline line;
    std::vector<RecentredPart> recentred;
};

/// A path may leave the lumen between two points of a line that both lie in it. The curve through
/// the points is a cubic spline (`fit_spline`), which is what `resample` follows; sparse points in
/// a bend are good enough for it. Where neither the straight segment nor the spline meets the wall
/// the line stays. Where only the spline does, points of the segment are put in. Where the segment
/// passes through the wall, the middle of the lumen between its two points (`least_cost_path`,
/// `centred_path`) takes its place if it keeps to the curve:
///
///     |middle - curve| <= 0.5 R,    R the distance to the wall from the middle
///
/// everywhere; otherwise nothing tells that the line means this way through the lumen.
///
/// @param line  in order, its points in the lumen, the ends on openings or in the lumen [m]
/// @throws GeometryError with the place, if the middle is farther away, or no path joins the points
LineInLumen with_path_in_lumen(const Polyline& line, const WallTree& wall);

}  // namespace braidzone
