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

/// Level of the parent vessel by the section nearest to the point; beyond the ends of a piece that
/// of an ellipsoid, which the neighbouring piece holds.
double section_level(const Phantom& phantom, const CrossSection& section, double arc_length,
                     const Vec3& point)
{
    const Vec3 offset = point - section.origin;
    if (phantom.ovality == 1.0) return offset.norm() - parent_radius(phantom, arc_length);
    const double cosine = std::cos(phantom.oval_direction);
    const double sine = std::sin(phantom.oval_direction);
    const double normal = offset.dot(section.normal), binormal = offset.dot(section.binormal);
    const HalfAxes axes = parent_half_axes(phantom, arc_length);
    return ellipsoid_level({cosine * normal + sine * binormal, cosine * binormal - sine * normal,
                            offset.dot(section.tangent)},
                           {axes.larger, axes.smaller, axes.smaller});
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

HalfAxes parent_half_axes(const Phantom& phantom, double arc_length)
{
    const double radius = parent_radius(phantom, arc_length);
    return {radius / std::sqrt(phantom.ovality), radius * std::sqrt(phantom.ovality)};
}

double ellipsoid_level(const Vec3& point, const Vec3& half_axes)
{
    const Vec3 scaled = point.cwiseQuotient(half_axes);
    const double k0 = scaled.norm();
    const double k1 = scaled.cwiseQuotient(half_axes).norm();
    if (!(k1 > 0.0)) return -half_axes.minCoeff();
    return k0 * (k0 - 1.0) / k1;
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
            lowest = std::min(lowest, section_level(phantom, section_along(piece, along),
                                                    piece.arc_length + along, point));
        }
        return lowest;
    };
    const double widest =
        std::max(parent_half_axes(phantom, 0.0).larger,
                 parent_half_axes(phantom, std::numeric_limits<double>::infinity()).larger);
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
        return ellipsoid_level({across, 0.0, along}, {half_across, half_across, half_height});
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
