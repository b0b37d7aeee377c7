#pragma once

#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"

#include <optional>
#include <vector>

namespace braidzone {

/// A stretch of the centerline.
struct ArcRange {
    double from = 0.0;  ///< arc length [m]
    double to = 0.0;    ///< [m]; > from
};

/// What lies behind a part of the device that is free of the parent vessel's wall.
enum class OpeningKind {
    sac,     ///< a space without another way out: an aneurysm's neck, a fusiform widening
    branch,  ///< another opening of the vessel is reached: a branch's ostium
    end,     ///< the vessel itself: an end of the device that does not lie on the wall
};

/// A part of the device behind which the vessel opens: an aneurysm's neck, or the ostium of a
/// branch. Flow passes through the braid there.
struct WallOpening {
    std::vector<int> nodes;  ///< increasing
    int distal_ring = 0;     ///< first ring with such a node, or of the given stretch
    int proximal_ring = 0;   ///< the last one
    double area = 0.0;       ///< of the deployed device over the opening [m^2]
    /// As `told_apart` finds it (`opening_kind.hpp`).
    OpeningKind kind = OpeningKind::sac;
    std::vector<int> vessel_openings = {};  ///< reached through a branch, largest first
    bool in_sac = false;  ///< an end that lies in the mouth of a sac, or in a widening
};

struct NeckOptions {
    /// A ring looks into an opening if its wall is somewhere that many times further off than in
    /// the tube: more than an oval lumen of 1 : 1.4 or a hub that is off by a fifth.
    double opening_ratio = 1.5;
    /// A node belongs to an opening if the wall behind it is that many times further off than the
    /// parent vessel's: clearly outside, past the fillet at the neck's edge.
    double outside_ratio = 1.2;
    /// Fewer nodes are unevenness of the wall. An ostium of 0.4 mm takes about three.
    int fewest_nodes = 3;
    /// Where the neck is, if it is not to be looked for.
    std::optional<ArcRange> given;
};

/// Finds where the vessel opens behind a device, largest area first; the first one counts as the
/// neck.
///
/// The parent vessel's tube is taken from the vessel's wall as seen from the ring hubs. With d the
/// distance from the hub to the wall in a direction of the ring's plane,
///
///     b(ring)         = lower quartile of d over the directions
///     ring is open    if max d > opening_ratio b, or within b of such a ring along the centerline
///     parent(ring, direction) = d where the ring is closed; across a stretch of open rings linear
///                       in arc length between the closed rings on both sides, direction by
///                       direction
///     node is outside if its ring is open and d > outside_ratio parent
///
/// so that a taper, a bend, an oval lumen or a centerline off the middle make no neck. Outside
/// nodes that share a rhombus form one opening. Where one end of the device lies in an opening, the
/// closed side alone counts, where both do, b.
///
/// The ostium of a side branch is an opening as well, and so is the second daughter of a
/// bifurcation. A widening all round is none, unless it is given; an opening that takes more than
/// three quarters of a ring is not told from one.
///
/// `options.given` takes the place of the rule for open rings in that stretch; what lies outside
/// the tube there is the first opening, whatever its size (it may have no node).
///
/// @throws GeometryError if the device does not reach into the given stretch
std::vector<WallOpening> find_openings(const Deployment& deployment, const WallTree& wall,
                                       const NeckOptions& options = {});

/// The neck: the first of the openings if a sac lies behind it; none otherwise. Openings that are
/// not told apart count as sacs.
const WallOpening* neck_of(const std::vector<WallOpening>& openings);

/// For each node of a lattice, 1 if it belongs to one of the openings.
std::vector<char> nodes_of(const std::vector<WallOpening>& openings, int num_nodes);

}  // namespace braidzone
