#include "core/phantom_shape.hpp"

#include "core/error.hpp"
#include "core/phantom_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

std::string numbered(const std::string& name, std::size_t index)
{
    return fmt::format("{} {}", name, index + 1);
}

Vec3 across_direction(const CrossSection& section, double direction)
{
    return std::cos(direction) * section.normal + std::sin(direction) * section.binormal;
}

/// Height above the axis, along `outwards`, of the neck's plane: the farthest at which the two ends
/// of the neck's diameter along `along` lie on the host vessel's wall (on average).
double neck_height(const std::function<double(const Vec3&)>& host_level, const Vec3& base,
                   const Vec3& outwards, const Vec3& along, double neck, double host_radius,
                   const std::string& name)
{
    const auto mean_level = [&](double height) {
        const Vec3 middle = base + height * outwards;
        return host_level(middle + 0.5 * neck * along) + host_level(middle - 0.5 * neck * along);
    };
    const double highest = 3.0 * host_radius + neck;
    const double step = 0.02 * host_radius;
    double height = highest;
    while (height > -highest && mean_level(height) > 0.0)
        height -= step;
    if (height <= -highest) {
        throw ConfigError(
            fmt::format("{}: a neck of {:.6g} mm does not meet the vessel", name, 1e3 * neck));
    }
    double inside = height, outside = height + step;
    while (outside - inside > 1e-9 * host_radius) {
        const double middle = 0.5 * (inside + outside);
        (mean_level(middle) > 0.0 ? outside : inside) = middle;
    }
    return inside;
}

/// Puts the sac on its host: parent vessel, or whole bifurcation.
/// @return height of the neck's plane above the axis [m]
double place_sac(PhantomShape& shape, const PhantomSac& sac, const std::string& name,
                 const std::function<double(const Vec3&)>& host_level, const Vec3& base,
                 const Vec3& outwards, const Vec3& along, double host_radius)
{
    const double plane =
        neck_height(host_level, base, outwards, along, sac.neck, host_radius, name);
    // The ellipsoid is as wide as the neck at this height below its centre.
    const double relative_neck = sac.neck / sac.diameter;
    const double below_centre = 0.5 * sac.height * std::sqrt(1.0 - relative_neck * relative_neck);
    shape.parts.push_back(ellipsoid(name, sac, base + (plane + below_centre) * outwards, outwards));
    return plane;
}

void add_branch(PhantomShape& shape, const PhantomBranch& branch, const std::string& name)
{
    const CrossSection section = section_along(shape.axis, branch.position);
    const Vec3 outwards = std::cos(branch.tilt) * section.tangent +
                          std::sin(branch.tilt) * across_direction(section, branch.direction);
    const Vec3 end = section.origin + branch.length * outwards;
    shape.ends.push_back({end, outwards, branch.radius, shape.parts.size()});
    shape.parts.push_back(
        straight_tube(name, section.origin, end + shape.overhang * outwards, branch.radius));
}

/// Height above the daughters' origin at which their walls meet [m].
double crotch_height(const PhantomBifurcation& bifurcation)
{
    return bifurcation.radius / std::sin(bifurcation.half_angle);
}

void add_daughters(PhantomShape& shape, const PhantomBifurcation& bifurcation)
{
    const CrossSection apex = section_along(shape.axis, shape.axis.length);
    for (const double side : {1.0, -1.0}) {
        const Vec3 outwards = std::cos(bifurcation.half_angle) * apex.tangent +
                              side * std::sin(bifurcation.half_angle) * apex.normal;
        const Vec3 end = apex.origin + bifurcation.length * outwards;
        shape.ends.push_back({end, outwards, bifurcation.radius, shape.parts.size()});
        shape.parts.push_back(straight_tube(side > 0.0 ? "first daughter" : "second daughter",
                                            apex.origin, end + shape.overhang * outwards,
                                            bifurcation.radius));
    }
}

void add_sidewall_sac(PhantomShape& shape, const Phantom& phantom, const PhantomSac& sac,
                      const std::string& name)
{
    const CrossSection section = section_along(shape.axis, *sac.position);
    place_sac(shape, sac, name, shape.parts.front().level, section.origin,
              across_direction(section, sac.direction), section.tangent,
              parent_radius(phantom, *sac.position));
}

/// A sac between the daughters; a tube of the neck's diameter joins it to the crotch, which a sac
/// that rests on the daughters need not reach.
void add_apex_sac(PhantomShape& shape, const Phantom& phantom, const PhantomSac& sac,
                  const std::string& name)
{
    const CrossSection apex = section_along(shape.axis, shape.axis.length);
    const PhantomShape host = shape;
    const double plane = place_sac(
        shape, sac, name, [&host](const Vec3& point) { return level(host, point); }, apex.origin,
        apex.tangent, apex.normal, phantom.distal_radius);
    const double crotch = crotch_height(*phantom.bifurcation);
    shape.parts.push_back(straight_tube("neck of " + name, apex.origin + crotch * apex.tangent,
                                        apex.origin + plane * apex.tangent, 0.5 * sac.neck));
}

/// Refuses parts that would spoil the square cut at an end.
void require_clear_ends(const PhantomShape& shape)
{
    constexpr int around = 32;
    for (const PhantomEnd& end : shape.ends) {
        const Vec3 normal = end.outwards.unitOrthogonal();
        const Vec3 binormal = end.outwards.cross(normal);
        for (std::size_t part = 0; part < shape.parts.size(); ++part) {
            if (part == end.part) continue;
            for (int i = 0; i < around; ++i) {
                const double angle = 2.0 * std::numbers::pi * i / around;
                const Vec3 rim = end.centre + end.radius * (std::cos(angle) * normal +
                                                            std::sin(angle) * binormal);
                if (shape.parts[part].level(rim) > shape.blend_radius) continue;
                throw ConfigError(fmt::format(
                    "{} reaches the opening of {}; there must be more than the blend radius, "
                    "{:.6g} mm, between them",
                    shape.parts[part].name, shape.parts[end.part].name, 1e3 * shape.blend_radius));
            }
        }
    }
}

}  // namespace

PhantomShape make_shape(const Phantom& phantom)
{
    require_valid(phantom);
    PhantomShape shape;
    shape.axis = make_axis(phantom.segments);
    shape.blend_radius = phantom.blend_radius;
    // Beyond the cut the tube continues straight for some triangles, so that its round end does
    // not reach them.
    shape.overhang = 3.0 * phantom.edge_length;

    const CrossSection inlet = section_along(shape.axis, 0.0);
    shape.ends.push_back({inlet.origin, -inlet.tangent, parent_half_axes(phantom, 0.0).larger, 0});
    if (phantom.bifurcation) {
        const PhantomBifurcation& bifurcation = *phantom.bifurcation;
        // The parent's round end must not bulge through the crotch of the daughters; ending early
        // it touches it.
        const double retreat = std::max(0.0, phantom.distal_radius - crotch_height(bifurcation));
        PhantomAxis shortened = shape.axis;
        AxisPiece& last = shortened.pieces.back();
        last.length = std::max(last.length - retreat, 0.5 * last.length);
        shape.parts.push_back(parent_tube(phantom, shortened, shape.overhang, 0.0));
        add_daughters(shape, bifurcation);
    } else {
        const CrossSection outlet = section_along(shape.axis, shape.axis.length);
        shape.ends.push_back({outlet.origin, outlet.tangent,
                              parent_half_axes(phantom, shape.axis.length).larger, 0});
        shape.parts.push_back(parent_tube(phantom, shape.axis, shape.overhang, shape.overhang));
    }
    for (std::size_t i = 0; i < phantom.branches.size(); ++i) {
        add_branch(shape, phantom.branches[i], numbered("branch", i));
    }
    for (std::size_t i = 0; i < phantom.sacs.size(); ++i) {
        const PhantomSac& sac = phantom.sacs[i];
        const std::string name = numbered("sac", i);
        if (sac.edge_length > 0.0) {
            shape.domes.push_back({shape.parts.size(), sac.edge_length});
        }
        if (sac.position) {
            add_sidewall_sac(shape, phantom, sac, name);
        } else {
            add_apex_sac(shape, phantom, sac, name);
        }
    }
    require_clear_ends(shape);
    return shape;
}

double level(const PhantomShape& shape, const Vec3& point)
{
    double value = shape.parts.front().level(point);
    for (std::size_t i = 1; i < shape.parts.size(); ++i) {
        value = smooth_minimum(value, shape.parts[i].level(point), shape.blend_radius);
    }
    return value;
}

Vec3 level_gradient(const PhantomShape& shape, const Vec3& point, double step)
{
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 offset = step * Vec3::Unit(axis);
        gradient[axis] =
            (level(shape, point + offset) - level(shape, point - offset)) / (2.0 * step);
    }
    return gradient;
}

}  // namespace braidzone
