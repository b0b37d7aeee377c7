#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

/// Moves the hubs of rings, within their planes, towards the side on which no wall holds them.
///
/// Wires that slide around their rings gather where nothing presses on them, and a ring lies nearer
/// to that side than the balance of its radial springs has it (`ring_centring.hpp`): the braid
/// bulges further into a neck. How open a ring is in a direction e grows from 0, where the wall
/// stands at the nominal radius, to 1 at half as far again, so that hubs move continuously with the
/// device:
///
///     o = 2 / n sum over directions of clamp((d(e) - R0) / (R0 / 2), 0, 1) e,
///     shift of a hub = size o / max(largest |o| of the device, 0.2)
///
/// with o smoothed along the device over half a nominal radius. The ring that is open widest moves
/// by `size`, in front of a neck of an eighth of the circumference or more; a device without an
/// open side stays.
///
/// @param rings           to be moved
/// @param arc_lengths     of the rings on the centerline [m]
/// @param nominal_radius  R0 [m]
/// @param size            of the shift [m]; >= 0
void shift_hubs(std::vector<CrossSection>& rings, const std::vector<double>& arc_lengths,
                const WallTree& wall, double nominal_radius, double size);

}  // namespace braidzone
