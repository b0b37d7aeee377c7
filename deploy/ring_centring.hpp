#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

/// The cross-sections of the rings, each moved within its plane to the middle of the lumen as the
/// ring feels it, by
///
///     sum over directions of max(0, reach - (w - d . e)) e = 0,   reach = min(R0, 1.2 r)
///
/// with e the directions, w the distance of the wall from the centerline and r the inscribed radius
/// there. At reach = R0 this is the balance of a ring's radial springs to first order in d: w - d .
/// e is the distance of the wall from the ring's hub. The next order, d^2 / (2 w), is 3 um for 0.1
/// mm in a vessel of 1.8 mm. It is left out: seen from a hub that has moved, the edges of a wide
/// neck stand further apart, which moves the hub on, until it leaves the vessel for the sac at one
/// radius of the vessel and not at the next.
///
/// The second limit keeps a ring of a much too large device near the wall that carries it: what is
/// further off than the nearest wall by more than a fifth does not draw the ring. A ring with room
/// on all sides stays on the centerline.
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
