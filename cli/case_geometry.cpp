#include "cli/case_geometry.hpp"

#include "core/centerline_compute.hpp"
#include "core/centerline_io.hpp"
#include "core/error.hpp"
#include "core/surface_io.hpp"
#include "core/wall_offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace braidzone {
namespace {

Vec3 end_point(const CenterlineEnd& end, const Vessel& vessel)
{
    if (const Vec3* point = std::get_if<Vec3>(&end)) return *point;
    const auto opening = static_cast<std::size_t>(std::get<int>(end));
    if (opening < vessel.openings.size()) return vessel.openings[opening].centre;
    throw ConfigError(fmt::format("{} is no opening of the vessel; it has\n{}", opening,
                                  describe_openings(vessel)));
}

/// The centerline's ends if both are points: a vessel with rounded ends is cut open there.
std::optional<VesselEnds> given_points(const VesselSource& source)
{
    if (!source.from || !source.to) return std::nullopt;
    const Vec3* from = std::get_if<Vec3>(&*source.from);
    const Vec3* to = std::get_if<Vec3>(&*source.to);
    if (from == nullptr || to == nullptr) return std::nullopt;
    return VesselEnds{*from, *to};
}

Polyline read_given_centerline(const VesselSource& source, const Vessel& vessel,
                               const WallTree& wall)
{
    Polyline line = read_centerline(*source.centerline, vessel.unit, source.centerline_line);
    if (source.reverse_centerline) {
        std::reverse(line.points.begin(), line.points.end());
        std::reverse(line.inscribed_radii.begin(), line.inscribed_radii.end());
    }
    if (source.wall_offset != 0.0) line.inscribed_radii.clear();  // those of the wall as it was
    try {
        return with_inscribed_radii(line, wall);
    } catch (const GeometryError& error) {
        throw GeometryError(fmt::format("{}: {}", source.centerline->string(), error.what()));
    }
}

/// The vessel with its wall moved, if nothing of it crosses itself then.
Vessel moved_outwards(const Vessel& vessel, double offset)
{
    try {
        return with_wall(vessel, with_wall_offset(vessel.wall, offset));
    } catch (const GeometryError& error) {
        throw GeometryError(fmt::format(
            "the surface is sound as it is, and no longer with vessel.wall_offset = {:.6g} mm "
            "(take a smaller one, or a surface with larger triangles): {}",
            1e3 * offset, error.what()));
    }
}

}  // namespace

Vessel read_vessel(const VesselSource& source)
{
    const LabelledSurface surface = read_labelled_surface(source.surface, source.unit);
    VesselOptions options{
        .repair = source.repair, .ends = given_points(source), .orders = source.openings};
    if (source.centerline) {
        options.lines.push_back(
            read_centerline(*source.centerline, source.unit, source.centerline_line).points);
    }
    try {
        Vessel vessel = make_vessel(surface, source.unit, options);
        if (source.wall_offset == 0.0) return vessel;
        return moved_outwards(vessel, source.wall_offset);
    } catch (const GeometryError& error) {
        throw GeometryError(fmt::format("{}: {}", source.surface.string(), error.what()));
    }
}

Polyline find_centerline(const VesselSource& source, const Vessel& vessel, const WallTree& wall)
{
    if (source.centerline) return read_given_centerline(source, vessel, wall);
    if (!source.from && vessel.openings.size() != 2) {
        throw ConfigError(
            fmt::format("the vessel has {} openings, so vessel.from and vessel.to must "
                        "tell between which ones the centerline runs:\n{}",
                        vessel.openings.size(), describe_openings(vessel)));
    }
    return compute_centerline(vessel, wall, end_point(source.from.value_or(0), vessel),
                              end_point(source.to.value_or(1), vessel));
}

double arc_length_at(const PlaceOnCenterline& place, const Centerline& centerline)
{
    if (const double* arc_length = std::get_if<double>(&place)) return *arc_length;
    return nearest_arc_length(centerline, std::get<Vec3>(place));
}

int nearest_opening(const Vessel& vessel, const Vec3& point)
{
    const auto nearest = std::min_element(vessel.openings.begin(), vessel.openings.end(),
                                          [&](const Opening& first, const Opening& second) {
                                              return (first.centre - point).squaredNorm() <
                                                     (second.centre - point).squaredNorm();
                                          });
    return static_cast<int>(nearest - vessel.openings.begin());
}

std::string describe_openings(const Vessel& vessel)
{
    std::string text;
    for (std::size_t i = 0; i < vessel.openings.size(); ++i) {
        const Opening& opening = vessel.openings[i];
        const Vec3 centre = opening.centre * 1e3;
        text += fmt::format("{}  {}: diameter {:.2f} mm at ({:.2f}, {:.2f}, {:.2f}) mm, {}",
                            i == 0 ? "" : "\n", i, 2e3 * opening.radius, centre.x(), centre.y(),
                            centre.z(), opening.kind);
    }
    return text;
}

}  // namespace braidzone
