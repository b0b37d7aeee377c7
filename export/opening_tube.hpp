#pragma once

#include "core/triangle_mesh.hpp"
#include "core/vessel.hpp"

#include <vector>

namespace braidzone {

/// The outline of an opening, swept from it towards an axis: rings of as many points as the rim
/// has, the rim first.
struct TubeRings {
    std::vector<std::vector<Vec3>> rings;
    std::vector<double> arc_lengths;  ///< of each, along the middle [m]
};

/// Sweeps the outline along the opening's normal, then along an arc until it looks along
/// `direction`. What of the rim lies off its plane is gone at the arc's beginning.
///
///     centre(s) = c + s n                                            s < straight
///     centre    = c + straight n + R (sin phi n + (1 - cos phi) m)   phi from 0 to the angle
///
/// with R twice the largest distance of the rim from its middle, and m the unit vector across n
/// towards `direction`. The outline turns about n x m by phi, so that it is not twisted.
///
/// @param direction  unit, not opposite to the opening's normal
/// @param straight   [m]
TubeRings bent_tube(const Vessel& vessel, const Opening& opening, const Vec3& direction,
                    double straight);

/// Goes on along `direction` to the plane at `height` along it; the last ring lies in it.
void continue_to_plane(TubeRings& tube, const Vec3& direction, double height);

/// Adds the tube's wall to a mesh that has the rim's points.
/// @return the points of the last ring
std::vector<int> append_tube(TriangleMesh& mesh, const std::vector<int>& rim,
                             const TubeRings& tube);

}  // namespace braidzone
