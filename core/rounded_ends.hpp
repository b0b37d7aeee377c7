#pragma once

#include "core/opening.hpp"
#include "core/wall_tree.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// A closed end of a vessel: of a branch that segmentation rounded off, or the dome of a sac.
struct RoundedEnd {
    Vec3 tip = Vec3::Zero();        ///< the outermost point of the wall there [m]
    Vec3 centre = Vec3::Zero();     ///< in the lumen, about a radius behind the tip [m]
    Vec3 outwards = Vec3::UnitX();  ///< unit, along the lumen
    double radius = 0.0;            ///< of the lumen about the tip [m]
};

/// The closed ends of a surface, widest first.
///
/// They are the places farthest along the surface from its openings or, without any, from one of
/// its ends, which is found as the point farthest from an arbitrary one: the local maxima of the
/// length of the shortest path along edges (Dijkstra 1959, doi 10.1007/BF01386390) that rise above
/// the saddle to any higher one (their persistence) by more than the radius of the lumen about
/// them, and about which the wall is a dome, not a band about the lumen,
/// with no wall within 2.3 radii behind the tip. That radius is the first
/// largest distance to the wall on the way inwards. The axis runs through the mean points of two
/// bands of the wall about the tip, 1.3 to 1.9 and 2.3 to 2.9 radii from it; the equator of a half
/// sphere is at 1.57.
///
/// @param mesh      sound
/// @param openings  its rims
std::vector<RoundedEnd> rounded_ends(const TriangleMesh& mesh, const std::vector<Opening>& openings,
                                     const WallTree& wall);

}  // namespace braidzone
