#pragma once

#include "core/vessel.hpp"
#include "deploy/lumen_tube.hpp"

#include <array>
#include <vector>

namespace braidzone {

/// The wall outside the parent vessel's tube, by regions.
struct WallRegions {
    static constexpr int none = -1;  ///< the parent vessel's own wall

    std::vector<int> of_triangle;  ///< `none` or a region's number
    /// For each region, the openings of the vessel that it reaches, increasing, without those at
    /// the ends of the centerline; none for a sac.
    std::vector<std::vector<int>> branches;
};

/// Parts the wall outside the parent's tube.
///
/// A triangle lies outside a tube if its middle is at a relative distance of more than 1.2
/// (`relative_distance`). Triangles outside the parent's tube that share edges form a region.
/// @param ends  the vessel's openings at the two ends of the centerline
WallRegions wall_regions(const Vessel& vessel, const LumenTube& parent,
                         const std::array<int, 2>& ends);

/// Makes regions of their own of the sacs in a region that reaches branches, where the mouth of a
/// sac and the ostium of a branch run into each other: of what lies outside the tubes of the
/// branches too (`branch_tube`), parts that rise beyond 1.6 times the radius of every tube and have
/// at least half as much wall as the parent has cross-section. What remains is the branch's. The
/// region stays whole if the way of a branch is not found.
/// @param region  a number of `regions`
/// @param reach   how far walls are looked for [m]
void part_sacs_from_branches(WallRegions& regions, int region, const Vessel& vessel,
                             const WallTree& wall, const LumenTube& parent, double reach);

}  // namespace braidzone
