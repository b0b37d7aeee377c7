#include "export/foam_block.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

Vec3 point_in_lumen(const Vessel& vessel, const WallTree& wall)
{
    Vec3 best = Vec3::Zero();
    double best_clearance = 0.0;
    for (const Opening& opening : vessel.openings) {
        // Up to two radii deep; further on the vessel may turn away.
        for (int step = 1; step <= 8; ++step) {
            const double depth = 0.25 * step * opening.radius;
            const Vec3 point = opening.centre - depth * opening.normal;
            const double clearance = std::min(depth, wall.nearest(point).distance);
            if (clearance > best_clearance && wall.contains(point)) {
                best = point;
                best_clearance = clearance;
            }
        }
    }
    if (!(best_clearance > 0.0))
        throw GeometryError(
            "no point within two radii of an opening's centre lies in the lumen; the openings must "
            "be cut across the vessel");
    return best;
}

FoamBlock block_around(const Vessel& vessel, const Vec3& inside, double cell)
{
    if (!(cell > 0.0))
        throw InputError(fmt::format("background cells of {:.6g} m; must be positive", cell));
    const Box box = bounding_box(vessel.wall);
    FoamBlock block;
    block.cell = cell;
    for (int axis = 0; axis < 3; ++axis) {
        const double third = inside[axis] - cell / 3.0;  // a corner of the cell that holds `inside`
        const double below = std::ceil((third - box.lower[axis]) / cell) + 1.0;
        const double above = std::ceil((box.upper[axis] - third) / cell) + 1.0;
        block.lower[axis] = third - below * cell;
        block.num_cells[static_cast<std::size_t>(axis)] = static_cast<int>(below + above);
    }
    return block;
}

}  // namespace braidzone
