#include "export/braid_inset.hpp"

#include <algorithm>

namespace braidzone {

Vec3 off_the_wall(const Vec3& point, const Vec3& normal, const WallTree& wall, double distance)
{
    // After a first move another part of a curved wall may be the nearest.
    constexpr int most_moves = 4;
    constexpr double smallest_cosine = 0.5;  // against a wall that stands across the braid
    Vec3 moved = point;
    for (int move = 0; move < most_moves; ++move) {
        const WallPoint nearest = wall.nearest(moved);
        if (nearest.distance >= distance) return moved;
        const bool is_outside = (moved - nearest.point).dot(nearest.normal) > 0.0;
        const double depth = is_outside ? -nearest.distance : nearest.distance;
        const double cosine = std::max(smallest_cosine, normal.dot(nearest.normal));
        moved -= (distance - depth) / cosine * normal;
    }
    return moved;
}

}  // namespace braidzone
