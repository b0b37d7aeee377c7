#include "deploy/press_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace braidzone {

namespace {

/// Bisections that find where a segment enters a solid: to 1e-9 of its length.
constexpr int entry_bisections = 30;

/// A direction in the plane of x and z, mirrored for the half at negative x.
Vec3 in_section(int side, double x, double z)
{
    return {side * x, 0.0, z};
}

}  // namespace

SolidDistance distance_to_block(const PressBench& bench, int side, const Vec3& point)
{
    // The rounded wedge is a sharp one further in, thickened by the edge's radius.
    const double half_angle = 0.5 * bench.notch_angle;
    const Vec3 top_normal = in_section(side, 0.0, 1.0);
    const Vec3 face_normal = in_section(side, -std::cos(half_angle), std::sin(half_angle));
    const Vec3 along_top = in_section(side, 1.0, 0.0);
    const Vec3 down_face = in_section(side, -std::sin(half_angle), -std::cos(half_angle));
    const Vec3 corner =
        in_section(side, 0.5 * bench.notch_width, 0.0) -
        bench.edge_radius / (1.0 + top_normal.dot(face_normal)) * (top_normal + face_normal);
    Vec3 away = point - corner;
    away.y() = 0.0;
    const double above_top = top_normal.dot(away), above_face = face_normal.dot(away);
    const bool beside_top = along_top.dot(away) >= 0.0, beside_face = down_face.dot(away) >= 0.0;
    if (above_top <= 0.0 && above_face <= 0.0) {
        return above_top > above_face ? SolidDistance{above_top - bench.edge_radius, top_normal}
                                      : SolidDistance{above_face - bench.edge_radius, face_normal};
    }
    if (beside_top && above_top > 0.0) return {above_top - bench.edge_radius, top_normal};
    if (beside_face && above_face > 0.0) return {above_face - bench.edge_radius, face_normal};
    return {away.norm() - bench.edge_radius, away.normalized()};
}

SolidDistance distance_to_head(const PressBench& bench, double height, const Vec3& point)
{
    if (bench.head == PressHead::flat) return {height - point.z(), -Vec3::UnitZ()};
    const double axis = height + bench.head_radius;
    const Vec3 away(point.x(), 0.0, std::min(0.0, point.z() - axis));
    const double length = away.norm();
    // A point on the axis or in the middle of the blade is as near to the one side as to the other.
    if (!(length > 0.0)) return {-bench.head_radius, -Vec3::UnitZ()};
    return {length - bench.head_radius, away / length};
}

double notch_depth(const PressBench& bench)
{
    return 0.5 * bench.notch_width / std::tan(0.5 * bench.notch_angle);
}

Obstacle solid_obstacle(std::function<SolidDistance(const Vec3& point)> distance, double reach)
{
    Obstacle obstacle;
    obstacle.clearance = [distance, reach](const Vec3& point) {
        return distance(point).distance - reach;
    };
    obstacle.pieces = [distance, reach](const Vec3& point, double range,
                                        std::vector<ContactPlane>& planes) {
        const SolidDistance nearest = distance(point);
        if (nearest.distance < range + reach) planes.push_back({nearest.distance, -nearest.normal});
    };
    obstacle.passage = [distance, reach](const Vec3& from,
                                         const Vec3& to) -> std::optional<ContactPlane> {
        if (!(distance(to).distance < 0.0) || !(distance(from).distance > reach)) {
            return std::nullopt;
        }
        double outside = 0.0, inside = 1.0;
        for (int i = 0; i < entry_bisections; ++i) {
            const double middle = 0.5 * (outside + inside);
            (distance(from + middle * (to - from)).distance > 0.0 ? outside : inside) = middle;
        }
        const Vec3 entry = from + outside * (to - from);
        const Vec3 outward = -distance(entry).normal;
        return ContactPlane{outward.dot(entry - from), outward};
    };
    return obstacle;
}

}  // namespace braidzone
