#pragma once

#include "core/centerline.hpp"
#include "core/opening.hpp"
#include "core/wall_tree.hpp"
#include "deploy/wall_profile.hpp"

#include <vector>

namespace braidzone {

/// A tube of the lumen, without what opens into it: sections along it, and the distance from the
/// hub of each to the tube's wall, across the mouths of sacs and branches the tube's own as
/// `parent_profiles` continues it.
struct LumenTube {
    std::vector<CrossSection> sections;
    std::vector<WallProfile> radii;
};

/// The tube along a centerline: four sections a mean radius, which follow a bend as tight as the
/// vessel is wide within 15 degrees.
/// @param reach  how far walls are looked for [m]
LumenTube tube_along(const WallTree& wall, const Centerline& centerline, double reach);

/// The tube of a branch, from an opening of the vessel up to the parent's tube.
///
/// Its axis is the centred path of least cost (`least_cost_path`, `centred_path`) from the opening
/// to a hub of the parent, on a grid of a third of the opening's radius and with that radius as
/// cap, so that no sac beside it attracts it.
///
/// @param hub  of the parent, at the branch's ostium [m]
/// @return no section if no path leads there, or all of it lies in the parent
LumenTube branch_tube(const WallTree& wall, const Opening& opening, const Vec3& hub,
                      const LumenTube& parent, double reach);

/// How far a point is from the hub of the tube's nearest section, over the tube's radius there in
/// the point's direction: above 1 outside the tube.
double relative_distance(const LumenTube& tube, const Vec3& point);

}  // namespace braidzone
