#include "core/surface_opening.hpp"

#include "core/centerline.hpp"
#include "core/error.hpp"
#include "core/lumen_path.hpp"
#include "core/path_centring.hpp"
#include "core/place_text.hpp"
#include "core/plane_cut.hpp"
#include "core/surface_check.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {

namespace {

void require_in_lumen(const Vec3& point, const WallTree& wall)
{
    if (!point.allFinite()) throw GeometryError("an end point of the vessel is not finite");
    if (wall.contains(point)) return;
    throw GeometryError(
        fmt::format("the end point {} is not in the lumen but {:.6g} mm from the wall, outside it",
                    place_text(point), 1e3 * wall.nearest(point).distance));
}

std::vector<Vec3> path_between(const VesselEnds& ends, const WallTree& wall, double mean_radius)
{
    const double distance = (ends.to - ends.from).norm();
    if (!(distance > mean_radius)) {
        throw GeometryError(fmt::format(
            "the vessel's end points {} and {} are {:.6g} mm apart, less than its mean radius of "
            "{:.6g} mm",
            place_text(ends.from), place_text(ends.to), 1e3 * distance, 1e3 * mean_radius));
    }
    const double spacing = mean_radius / 6.0;
    std::vector<Vec3> path = least_cost_path(wall, ends.from, ends.to, mean_radius, spacing);
    if (path.empty()) {
        throw GeometryError(
            fmt::format("no path through the lumen joins {} and {} on a grid of {:.6g} mm",
                        place_text(ends.from), place_text(ends.to), 1e3 * spacing));
    }
    return path;
}

/// The two ends of the lumen around a path, at the given points.
std::array<LumenEnd, 2> lumen_ends(const std::vector<Vec3>& path, const VesselEnds& ends,
                                   const WallTree& wall, double mean_radius)
{
    const Centerline axis =
        resample(centred_path(path, wall), {.spacing = mean_radius / 6.0, .smoothing = 0.0});
    const double length = axis.length();
    const double step = std::min(mean_radius, 0.25 * length);
    const auto end = [&](const Vec3& point, const CrossSection& near, const CrossSection& far) {
        const Vec3 tangent = (2.0 * near.tangent - far.tangent).normalized();
        return LumenEnd{point, tangent, std::max(near.inscribed_radius, far.inscribed_radius)};
    };
    LumenEnd first = end(ends.from, section_at(axis, step), section_at(axis, 2.0 * step));
    first.outwards = -first.outwards;
    return {first,
            end(ends.to, section_at(axis, length - step), section_at(axis, length - 2.0 * step))};
}

void require_plausible(const PlaneCut& cut, const LumenEnd& end, double whole_area)
{
    constexpr double most_widening = 2.0;  // a lumen four times as wide as high
    const double section_radius = std::sqrt(cut.section_area / std::numbers::pi);
    if (!(section_radius <= most_widening * end.radius)) {
        throw GeometryError(fmt::format(
            "the section across the lumen at the end point {} is {:.6g} mm wide, more than twice "
            "the {:.6g} mm of the vessel beside it; choose a point away from branches and sacs",
            place_text(end.point), 2e3 * section_radius, 2e3 * end.radius));
    }
    constexpr double most_radii = 5.0;
    constexpr double largest_area_share = 0.25;
    double reach = 0.0;
    for (const Vec3& point : cut.removed.points) {
        reach = std::max(reach, (point - end.point).norm());
    }
    const double area_share = surface_area(cut.removed) / whole_area;
    if (!(reach <= most_radii * end.radius && area_share <= largest_area_share)) {
        throw GeometryError(fmt::format(
            "cutting at the end point {} would take off {:.3g} % of the surface, up to {:.6g} mm "
            "from the point; a rounded tip has at most {:.3g} % and stays within five radii, "
            "{:.6g} mm; choose a point nearer to the tip",
            place_text(end.point), 1e2 * area_share, 1e3 * reach, 1e2 * largest_area_share,
            1e3 * most_radii * end.radius));
    }
}

}  // namespace

TriangleMesh open_rounded_ends(const TriangleMesh& surface, const VesselEnds& ends)
{
    Vessel closed;
    closed.wall = surface;
    const WallTree wall(closed);
    require_in_lumen(ends.from, wall);
    require_in_lumen(ends.to, wall);

    const double mean_radius = 2.0 * enclosed_volume(surface) / surface_area(surface);
    std::vector<Vec3> path = path_between(ends, wall, mean_radius);
    // A point off the axis bends the path towards itself: the first round only finds the axis.
    const auto [rough_first, rough_last] = lumen_ends(path, ends, wall, mean_radius);
    path.front() = cut_across(surface, ends.from, rough_first.outwards).section_centre;
    path.back() = cut_across(surface, ends.to, rough_last.outwards).section_centre;

    const std::array<LumenEnd, 2> cuts = lumen_ends(path, ends, wall, mean_radius);
    return cut_open(surface, {cuts.begin(), cuts.end()});
}

TriangleMesh cut_open(const TriangleMesh& surface, const std::vector<LumenEnd>& ends)
{
    const double area = surface_area(surface);
    TriangleMesh opened = surface;
    std::string places;
    for (const LumenEnd& end : ends) {
        PlaneCut cut = cut_across(opened, end.point, end.outwards);
        require_plausible(cut, end, area);
        opened = std::move(cut.kept);
        places += (places.empty() ? "" : " and ") + place_text(end.point);
    }
    const SurfaceDefects defects = find_defects(opened);
    if (!is_sound(defects)) {
        throw GeometryError(
            fmt::format("cut open at {}, the surface is defective:\n{}choose end points a little "
                        "farther inwards",
                        places, describe(defects)));
    }
    return opened;
}

std::optional<LumenEnd> end_of_line(const std::vector<Vec3>& line, const WallTree& wall)
{
    constexpr double least_share = 0.8;
    constexpr double largest_fall = 0.95;
    Polyline back;
    back.points.assign(line.rbegin(), line.rend());
    back.inscribed_radii.assign(line.size(), 1.0);
    const double length = resample(back, {.spacing = 1e-3, .smoothing = 0.0}).length();
    const Centerline way = resample(back, {.spacing = length / 400.0, .smoothing = 0.0});
    std::vector<double> radius;
    double largest = 0.0;
    for (const CrossSection& section : way.sections) {
        const bool is_inside = wall.contains(section.origin);
        radius.push_back(is_inside ? wall.nearest(section.origin).distance : 0.0);
        largest = std::max(largest, radius.back());
        if (radius.back() < largest_fall * largest) break;
    }
    if (!(largest > 0.0)) return std::nullopt;
    const auto first = std::find_if(radius.begin(), radius.end(),
                                    [&](double r) { return r >= least_share * largest; });
    const double place = static_cast<double>(first - radius.begin()) * way.spacing;
    const Vec3 point = section_at(way, place).origin;
    const Vec3 behind = section_at(way, std::min(place + largest, way.length())).origin;
    return LumenEnd{point, (point - behind).normalized(), largest};
}

}  // namespace braidzone
