#include "core/lumen_behind.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace braidzone {

namespace {

double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b)
{
    const Vec3 along = b - a;
    const double length2 = along.squaredNorm();
    const double share =
        length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (point - a - share * along).norm();
}

double distance_to_rim(const Vec3& point, const Opening& opening, const TriangleMesh& mesh)
{
    double nearest = std::numeric_limits<double>::infinity();
    const std::vector<int>& rim = opening.rim;
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const auto a = static_cast<std::size_t>(rim[k]);
        const auto b = static_cast<std::size_t>(rim[(k + 1) % rim.size()]);
        nearest = std::min(nearest, distance_to_segment(point, mesh.points[a], mesh.points[b]));
    }
    return nearest;
}

bool leads_inwards(const Vec3& point, const Opening& opening, const TriangleMesh& mesh,
                   const WallTree& wall)
{
    constexpr double largest_quotient = 0.9;
    constexpr double steepest_cosine = 0.9;  // 26 degrees off the normal
    const WallPoint foot = wall.nearest(point);
    if (!(foot.distance < largest_quotient * distance_to_rim(point, opening, mesh))) return false;
    const double cosine = (foot.point - point).dot(opening.normal) / foot.distance;
    return std::abs(cosine) < steepest_cosine || foot.distance == 0.0;
}

}  // namespace

LumenBehind lumen_behind(const Opening& opening, const TriangleMesh& mesh, const WallTree& wall)
{
    LumenBehind behind;
    if (!(opening.radius > 0.0)) return behind;
    for (const double depth : {0.5, 1.0, 1.5, 2.0}) {
        const Vec3 point = opening.centre - depth * opening.radius * opening.normal;
        behind.is_tube = behind.is_tube || leads_inwards(point, opening, mesh, wall);
    }
    constexpr double step = 0.5;  // over the rim's radius
    behind.radius =
        first_largest_distance(opening.centre, -opening.normal, step * opening.radius, wall);
    return behind;
}

double first_largest_distance(const Vec3& start, const Vec3& inwards, double step,
                              const WallTree& wall)
{
    constexpr int most_steps = 1000;
    constexpr double least_share = 0.95;
    double largest = 0.0;
    for (int k = 1; k < most_steps; ++k) {
        const double distance = wall.nearest(start + k * step * inwards).distance;
        if (distance < least_share * largest) break;
        largest = std::max(largest, distance);
        // The largest sphere's middle is a radius from the wall; farther on is another lumen.
        if (k * step > 1.5 * largest + 2.0 * step) break;
    }
    return largest;
}

}  // namespace braidzone
