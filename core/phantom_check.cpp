#include "core/phantom_check.hpp"

#include "core/error.hpp"
#include "core/phantom_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace braidzone {

namespace {

double millimetres(double length)
{
    return 1e3 * length;
}
double degrees(double angle)
{
    return 180.0 / std::numbers::pi * angle;
}

void require_positive(double length, const std::string& name)
{
    if (!(length > 0.0 && std::isfinite(length))) {
        throw ConfigError(
            fmt::format("{} = {:.6g} mm; it must be positive", name, millimetres(length)));
    }
}

/// Refuses a value outside [low, high]; both in the unit that the message names.
void require_within(double value, double low, double high, const std::string& unit,
                    const std::string& name)
{
    if (!(value >= low && value <= high)) {
        throw ConfigError(fmt::format("{} = {:.6g} {}; allowed are {:.6g} to {:.6g} {}", name,
                                      value, unit, low, high, unit));
    }
}

void require_direction(double angle, const std::string& name)
{
    require_within(degrees(angle), -360.0, 360.0, "deg", name);
}

std::string numbered(const std::string& name, std::size_t index)
{
    return fmt::format("{} {}", name, index + 1);
}

void require_valid_parent(const Phantom& phantom)
{
    require_positive(phantom.proximal_radius, "proximal radius");
    require_positive(phantom.distal_radius, "distal radius");
    require_positive(phantom.blend_radius, "blend radius");
    require_positive(phantom.edge_length, "edge length");
    if (phantom.segments.empty()) {
        throw ConfigError("the phantom has no segment; its parent vessel needs at least one");
    }
    if (!(phantom.ovality >= 0.5 && phantom.ovality <= 1.0)) {
        throw ConfigError(
            fmt::format("ovality = {:.6g}; allowed are 0.5 to 1 (round)", phantom.ovality));
    }
    require_direction(phantom.oval_direction, "oval direction");
    const double widest = std::max(parent_half_axes(phantom, 0.0).larger,
                                   parent_half_axes(phantom, axis_length(phantom)).larger);
    const double narrowest = std::min(phantom.proximal_radius, phantom.distal_radius);
    // Six edges around are the least that still make a tube.
    if (phantom.edge_length > narrowest) {
        throw ConfigError(
            fmt::format("edge length = {:.6g} mm; at most the smallest radius of the "
                        "parent vessel, {:.6g} mm, is allowed",
                        millimetres(phantom.edge_length), millimetres(narrowest)));
    }
    for (std::size_t i = 0; i < phantom.segments.size(); ++i) {
        const PhantomSegment& segment = phantom.segments[i];
        const std::string name = numbered("segment", i);
        require_positive(segment.length, name + ": length");
        require_within(degrees(segment.angle), 0.0, 360.0, "deg", name + ": angle");
        require_direction(segment.plane_angle, name + ": plane angle");
        if (segment.angle * widest >= segment.length) {
            throw ConfigError(fmt::format(
                "{}: {:.6g} deg over {:.6g} mm is a bend of radius {:.6g} mm; it must exceed the "
                "vessel's radius, {:.6g} mm",
                name, degrees(segment.angle), millimetres(segment.length),
                millimetres(segment.length / segment.angle), millimetres(widest)));
        }
    }
}

void require_on_axis(double position, double axis_length, const std::string& name)
{
    require_within(millimetres(position), 0.0, millimetres(axis_length), "mm", name + ": position");
}

void require_valid_sac(const PhantomSac& sac, const Phantom& phantom, const std::string& name)
{
    require_positive(sac.diameter, name + ": diameter");
    require_positive(sac.height, name + ": height");
    require_positive(sac.neck, name + ": neck");
    require_direction(sac.direction, name + ": direction");
    if (!(sac.neck < sac.diameter)) {
        throw ConfigError(
            fmt::format("{}: neck = {:.6g} mm; it must be narrower than the sac, "
                        "{:.6g} mm",
                        name, millimetres(sac.neck), millimetres(sac.diameter)));
    }
    if (!(sac.edge_length >= 0.0 && sac.edge_length <= 0.25 * sac.diameter)) {
        throw ConfigError(
            fmt::format("{}: edge length = {:.6g} mm; allowed is up to a quarter of "
                        "the diameter, {:.6g} mm",
                        name, millimetres(sac.edge_length), millimetres(0.25 * sac.diameter)));
    }
    if (sac.position) {
        require_on_axis(*sac.position, axis_length(phantom), name);
        return;
    }
    if (!phantom.bifurcation) {
        throw ConfigError(
            fmt::format("{}: position is missing; only at a bifurcation may it be absent", name));
    }
    if (!(sac.height >= sac.neck)) {
        throw ConfigError(fmt::format(
            "{}: height = {:.6g} mm; at the apex of a bifurcation it must be at least the neck's "
            "diameter, {:.6g} mm",
            name, millimetres(sac.height), millimetres(sac.neck)));
    }
}

void require_valid_branch(const PhantomBranch& branch, const Phantom& phantom,
                          const std::string& name)
{
    require_positive(branch.radius, name + ": radius");
    require_positive(branch.length, name + ": length");
    require_on_axis(branch.position, axis_length(phantom), name);
    require_direction(branch.direction, name + ": direction");
    require_within(degrees(branch.tilt), 10.0, 170.0, "deg", name + ": tilt");
    const double host_radius = parent_radius(phantom, branch.position);
    if (branch.radius > host_radius) {
        throw ConfigError(
            fmt::format("{}: radius = {:.6g} mm; at most that of the parent vessel there, {:.6g} "
                        "mm, is allowed",
                        name, millimetres(branch.radius), millimetres(host_radius)));
    }
}

void require_valid_bifurcation(const PhantomBifurcation& bifurcation, double distal_radius)
{
    require_positive(bifurcation.radius, "bifurcation: radius");
    require_positive(bifurcation.length, "bifurcation: length");
    require_within(degrees(bifurcation.half_angle), 10.0, 90.0, "deg", "bifurcation: half angle");
    if (bifurcation.radius > distal_radius) {
        throw ConfigError(
            fmt::format("bifurcation: radius = {:.6g} mm; at most the parent "
                        "vessel's distal radius, {:.6g} mm, is allowed",
                        millimetres(bifurcation.radius), millimetres(distal_radius)));
    }
}

}  // namespace

void require_valid(const Phantom& phantom)
{
    require_valid_parent(phantom);
    for (std::size_t i = 0; i < phantom.branches.size(); ++i) {
        require_valid_branch(phantom.branches[i], phantom, numbered("branch", i));
    }
    if (phantom.bifurcation) {
        require_valid_bifurcation(*phantom.bifurcation, phantom.distal_radius);
    }
    for (std::size_t i = 0; i < phantom.sacs.size(); ++i) {
        require_valid_sac(phantom.sacs[i], phantom, numbered("sac", i));
    }
}

}  // namespace braidzone
