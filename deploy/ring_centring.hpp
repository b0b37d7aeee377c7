#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

/// The cross-sections of the rings, each moved within its plane to the middle of the lumen as the
/// ring feels it:
///
///     sum over directions of min(wall distance, reach) e = 0,   reach = min(R0, 1.1 r)
///
/// with r the inscribed radius there. At reach = R0 this is the balance of a ring's radial springs.
/// The second limit keeps a ring at a neck near the wall that carries it: what is further off than
/// the nearest wall by more than a tenth does not draw the ring. A ring with room on all sides
/// stays on the centerline.
///
/// So the place of a device that fits tightly does not hang on how the centerline was made: two
/// centerlines that differ by a tenth of a millimetre give the same rings.
///
/// The middle is found at stations along the centerline and smoothed over half a nominal radius,
/// for the stiffness of the device along its axis.
///
/// @param arc_lengths     of the rings on the centerline [m]
/// @param nominal_radius  R0 [m]
std::vector<CrossSection> centred_rings(const Centerline& centerline, const WallTree& wall,
                                        const std::vector<double>& arc_lengths,
                                        double nominal_radius);

}  // namespace braidzone
