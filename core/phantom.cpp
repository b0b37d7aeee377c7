#include "core/phantom.hpp"

#include "core/phantom_axis.hpp"
#include "core/phantom_mesh.hpp"
#include "core/phantom_shape.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

// Points of the exact axis this far apart (in edges of the wall's triangles) resolve every bend.
constexpr double axis_spacing_in_edges = 0.5;

Polyline parent_axis(const Phantom& phantom, const PhantomAxis& axis, double to, double spacing)
{
    Polyline line;
    const int intervals = std::max(1, static_cast<int>(std::ceil(to / spacing)));
    for (int i = 0; i <= intervals; ++i) {
        const double arc_length = to * i / intervals;
        line.points.push_back(section_along(axis, arc_length).origin);
        line.inscribed_radii.push_back(parent_half_axes(phantom, arc_length).smaller);
    }
    return line;
}

/// From the parent's axis through an arc into the first daughter. The arc's radii are those of the
/// larger tube around it: what lies between the point and that tube's wall.
Polyline axis_through_first_daughter(const Phantom& phantom, const PhantomAxis& axis,
                                     double spacing)
{
    const PhantomBifurcation& bifurcation = *phantom.bifurcation;
    const CrossSection apex = section_along(axis, axis.length);
    const Vec3 daughter = std::cos(bifurcation.half_angle) * apex.tangent +
                          std::sin(bifurcation.half_angle) * apex.normal;
    const double half_tangent = std::tan(0.5 * bifurcation.half_angle);
    const double last_length =
        axis.pieces.back().curvature == 0.0 ? axis.pieces.back().length : 0.0;
    // The arc touches both axes at this distance from the corner, on their straight parts.
    const double corner =
        std::min({3.0 * bifurcation.radius * half_tangent, last_length, 0.5 * bifurcation.length});

    const double parent_radius = parent_half_axes(phantom, axis.length).smaller;
    Polyline line = parent_axis(phantom, axis, axis.length - corner, spacing);
    const auto add = [&](const Vec3& point) {
        const Vec3 offset = point - apex.origin;
        const double from_parent =
            (offset - std::min(0.0, offset.dot(apex.tangent)) * apex.tangent).norm();
        const double from_daughter = (offset - offset.dot(daughter) * daughter).norm();
        line.points.push_back(point);
        line.inscribed_radii.push_back(
            std::max(parent_radius - from_parent, bifurcation.radius - from_daughter));
    };
    const double bend_radius = corner / half_tangent;
    const Vec3 start = apex.origin - corner * apex.tangent;
    const double arc = bend_radius * bifurcation.half_angle;
    const int on_arc = static_cast<int>(std::ceil(arc / spacing));
    for (int i = 1; i <= on_arc; ++i) {
        const double angle = bifurcation.half_angle * i / on_arc;
        add(start +
            bend_radius * (std::sin(angle) * apex.tangent + (1.0 - std::cos(angle)) * apex.normal));
    }
    const double rest = bifurcation.length - corner;
    const int on_rest = std::max(1, static_cast<int>(std::ceil(rest / spacing)));
    for (int i = 1; i <= on_rest; ++i) {
        add(apex.origin + (corner + rest * i / on_rest) * daughter);
    }
    return line;
}

}  // namespace

PhantomVessel make_phantom(const Phantom& phantom)
{
    const PhantomShape shape = make_shape(phantom);
    const double spacing = axis_spacing_in_edges * phantom.edge_length;
    PhantomVessel vessel;
    vessel.wall = mesh_wall(shape, phantom.edge_length);
    vessel.centerline = phantom.bifurcation
                            ? axis_through_first_daughter(phantom, shape.axis, spacing)
                            : parent_axis(phantom, shape.axis, shape.axis.length, spacing);
    return vessel;
}

}  // namespace braidzone
