#include "discrepancy/lumen.hpp"

#include "core/wall_offset.hpp"

#include <algorithm>
#include <utility>

namespace braidzone {

Lumen with_moved_wall(const Lumen& lumen, double offset)
{
    Vessel vessel = with_wall(lumen.vessel, with_wall_offset(lumen.vessel.wall, offset));
    WallTree wall(vessel);
    Centerline centerline = lumen.centerline;
    for (CrossSection& section : centerline.sections)
        section.inscribed_radius = std::max(0.0, section.inscribed_radius + offset);
    return {std::move(vessel), std::move(wall), std::move(centerline)};
}

Lumen straightened_lumen(const Lumen& lumen, const VesselStraightening& straightening)
{
    WallWithCenterline bent_back = straightened(lumen.vessel.wall, lumen.centerline, straightening);
    Vessel vessel = with_wall(lumen.vessel, bent_back.wall);
    WallTree wall(vessel);
    return {std::move(vessel), std::move(wall), std::move(bent_back.centerline)};
}

}  // namespace braidzone
