#include "core/phantom_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace braidzone {

namespace {

Box box_around(const Vec3& centre, double radius)
{
    return {centre.array() - radius, centre.array() + radius};
}

Box united(const Box& a, const Box& b)
{
    return {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
}

}  // namespace

double axis_length(const Phantom& phantom)
{
    double length = 0.0;
    for (const PhantomSegment& segment : phantom.segments)
        length += segment.length;
    return length;
}

double parent_radius(const Phantom& phantom, double arc_length)
{
    const double fraction = std::clamp(arc_length / axis_length(phantom), 0.0, 1.0);
    return (1.0 - fraction) * phantom.proximal_radius + fraction * phantom.distal_radius;
}

PhantomPart parent_tube(const Phantom& phantom, const PhantomAxis& axis, double proximal_overhang,
                        double distal_overhang)
{
    const PhantomAxis extended = with_straight_ends(axis, proximal_overhang, distal_overhang);
    PhantomPart part;
    part.name = "parent vessel";
    part.level = [phantom, extended](const Vec3& point) {
        double lowest = std::numeric_limits<double>::infinity();
        for (const AxisPiece& piece : extended.pieces) {
            const double along = nearest_along(piece, point);
            const double distance = (point - section_along(piece, along).origin).norm();
            lowest = std::min(lowest, distance - parent_radius(phantom, piece.arc_length + along));
        }
        return lowest;
    };
    const double widest = std::max(phantom.proximal_radius, phantom.distal_radius);
    part.bounds = box_around(extended.pieces.front().start.origin, widest);
    for (const AxisPiece& piece : extended.pieces) {
        // Between points a quarter of a radius apart the axis stays within a radius of them.
        const int steps = static_cast<int>(std::ceil(4.0 * piece.length / widest));
        for (int i = 1; i <= steps; ++i) {
            const Vec3 point = section_along(piece, piece.length * i / steps).origin;
            part.bounds = united(part.bounds, box_around(point, 2.0 * widest));
        }
    }
    return part;
}

PhantomPart straight_tube(const std::string& name, const Vec3& from, const Vec3& to, double radius)
{
    PhantomPart part;
    part.name = name;
    part.level = [from, to, radius](const Vec3& point) {
        const Vec3 line = to - from;
        const double fraction = std::clamp((point - from).dot(line) / line.squaredNorm(), 0.0, 1.0);
        return (point - from - fraction * line).norm() - radius;
    };
    part.bounds = united(box_around(from, radius), box_around(to, radius));
    return part;
}

PhantomPart ellipsoid(const std::string& name, const PhantomSac& sac, const Vec3& centre,
                      const Vec3& outwards)
{
    PhantomPart part;
    part.name = name;
    const double half_across = 0.5 * sac.diameter, half_height = 0.5 * sac.height;
    part.level = [=](const Vec3& point) {
        const Vec3 offset = point - centre;
        const double along = offset.dot(outwards);
        const double across = (offset - along * outwards).norm();
        const double k0 = std::hypot(across / half_across, along / half_height);
        const double k1 =
            std::hypot(across / (half_across * half_across), along / (half_height * half_height));
        if (!(k1 > 0.0)) return -std::min(half_across, half_height);
        return k0 * (k0 - 1.0) / k1;
    };
    part.bounds = box_around(centre, std::max(half_across, half_height));
    return part;
}

double smooth_minimum(double a, double b, double radius)
{
    const double u = std::max(radius - a, 0.0), v = std::max(radius - b, 0.0);
    return std::max(radius, std::min(a, b)) - std::hypot(u, v);
}

}  // namespace braidzone
