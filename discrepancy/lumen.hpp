#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/vessel_straightening.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

/// Where a device is deployed: the vessel with its search tree and centerline.
struct Lumen {
    Vessel vessel;
    WallTree wall;
    Centerline centerline;
};

/// The same with its wall moved outwards by `offset` [m] (`with_wall_offset` in core), and
/// with it the inscribed radii along the centerline.
/// @throws GeometryError if the moved wall is no vessel
Lumen with_moved_wall(const Lumen& lumen, double offset);

/// The same with less curvature (`vessel_straightening.hpp` in core).
/// @throws GeometryError if the vessel cannot be straightened so far
Lumen straightened_lumen(const Lumen& lumen, const VesselStraightening& straightening);

}  // namespace braidzone
