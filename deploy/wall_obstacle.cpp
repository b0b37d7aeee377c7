#include "deploy/wall_obstacle.hpp"

namespace braidzone {

Obstacle wall_obstacle(const WallTree& wall)
{
    Obstacle obstacle;
    obstacle.clearance = [&wall](const Vec3& point) { return wall.nearest(point).distance; };
    obstacle.pieces = [&wall](const Vec3& point, double range, std::vector<ContactPlane>& planes) {
        for (const WallPoint& piece : wall.within(point, range)) {
            const Vec3 outward =
                piece.distance > 0.0 ? Vec3((piece.point - point) / piece.distance) : piece.normal;
            planes.push_back({piece.distance, outward});
        }
    };
    obstacle.passage = [&wall](const Vec3& from, const Vec3& to) -> std::optional<ContactPlane> {
        const std::optional<WallHit> hit = wall.first_hit(from, to);
        if (!hit) return std::nullopt;
        return ContactPlane{hit->normal.dot(hit->point - from), hit->normal};
    };
    return obstacle;
}

}  // namespace braidzone
