#include "discrepancy/lumen.hpp"

#include "core/wall_offset.hpp"

#include <utility>

namespace braidzone {

Lumen with_moved_wall(const Lumen& lumen, double offset)
{
    Vessel vessel = make_vessel(with_wall_offset(lumen.vessel.wall, offset), lumen.vessel.unit);
    WallTree wall(vessel);
    return {std::move(vessel), std::move(wall), lumen.centerline};
}

Lumen straightened_lumen(const Lumen& lumen, const VesselStraightening& straightening)
{
    WallWithCenterline bent_back = straightened(lumen.vessel.wall, lumen.centerline, straightening);
    Vessel vessel = make_vessel(bent_back.wall, lumen.vessel.unit);
    vessel.notes = lumen.vessel.notes;
    WallTree wall(vessel);
    return {std::move(vessel), std::move(wall), std::move(bent_back.centerline)};
}

}  // namespace braidzone
