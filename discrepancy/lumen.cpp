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

}  // namespace braidzone
