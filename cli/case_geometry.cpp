#include "cli/case_geometry.hpp"

#include "core/centerline_compute.hpp"
#include "core/centerline_io.hpp"
#include "core/error.hpp"
#include "core/line_order.hpp"
#include "core/place_text.hpp"
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

/// The lines of a case's centerline file, each in order.
struct LinesOfFile {
    std::vector<Polyline> lines;
    std::vector<std::string> notes;
};

LinesOfFile read_lines(const VesselSource& source)
{
    LinesOfFile file;
    int number = 0;
    for (const Polyline& line : read_centerlines(*source.centerline, source.unit)) {
        OrderedLine ordered = in_evident_order(line);
        if (ordered.num_misplaced > 0) {
            file.notes.push_back(fmt::format(
                "{} of the {} points of the centerline's line {} were not in the order in which "
                "they lie along the vessel, and have been put there",
                ordered.num_misplaced, line.points.size(), number));
        }
        file.lines.push_back(std::move(ordered.line));
        ++number;
    }
    return file;
}

/// The opening that an end of a given centerline stands for.
std::optional<int> opening_of(const std::optional<CenterlineEnd>& end, const char* key,
                              const Vessel& vessel)
{
    if (!end) return std::nullopt;
    if (const int* number = std::get_if<int>(&*end)) {
        end_point(*end, vessel);  // refuses a number that no opening has
        return *number;
    }
    const Vec3& point = std::get<Vec3>(*end);
    const int nearest = nearest_opening(vessel, point);
    const Opening& opening = vessel.openings[static_cast<std::size_t>(nearest)];
    if ((point - opening.centre).norm() <= 2.0 * opening.radius) return nearest;
    throw ConfigError(fmt::format(
        "{} = {} lies at none of the vessel's openings, between which a centerline from a file "
        "runs; they are\n{}",
        key, place_text(point, vessel.unit), describe_openings(vessel)));
}

GivenCenterline read_given_centerline(const VesselSource& source, const Vessel& vessel,
                                      const WallTree& wall)
{
    const LineChoice choice{.line = source.centerline_line,
                            .from = opening_of(source.from, "vessel.from", vessel),
                            .to = opening_of(source.to, "vessel.to", vessel),
                            .reverse = source.reverse_centerline};
    LinesOfFile file = read_lines(source);
    if (source.wall_offset != 0.0) {  // radii are those of the wall as it was
        for (Polyline& line : file.lines)
            line.inscribed_radii.clear();
    }
    GivenCenterline given = given_centerline(file.lines, vessel, wall, choice);
    given.notes.insert(given.notes.begin(), file.notes.begin(), file.notes.end());
    return given;
}

/// What `call` returns; errors of its shapes name the file.
template <typename Call>
auto with_file_name(const std::filesystem::path& file, const Call& call)
{
    try {
        return call();
    } catch (const GeometryError& error) {
        throw GeometryError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const ConfigError& error) {
        throw ConfigError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", file.string(), error.what()));
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
        const LinesOfFile file =
            with_file_name(*source.centerline, [&] { return read_lines(source); });
        for (const Polyline& line : file.lines)
            options.lines.push_back(line.points);
    }
    try {
        Vessel vessel = make_vessel(surface, source.unit, options);
        if (source.wall_offset == 0.0) return vessel;
        return moved_outwards(vessel, source.wall_offset);
    } catch (const GeometryError& error) {
        throw GeometryError(fmt::format("{}: {}", source.surface.string(), error.what()));
    }
}

GivenCenterline find_centerline(const VesselSource& source, const Vessel& vessel,
                                const WallTree& wall)
{
    if (source.centerline) {
        return with_file_name(*source.centerline,
                              [&] { return read_given_centerline(source, vessel, wall); });
    }
    if (!source.from && vessel.openings.size() != 2) {
        throw ConfigError(
            fmt::format("the vessel has {} openings, so vessel.from and vessel.to must "
                        "tell between which ones the centerline runs:\n{}",
                        vessel.openings.size(), describe_openings(vessel)));
    }
    return {compute_centerline(vessel, wall, end_point(source.from.value_or(0), vessel),
                               end_point(source.to.value_or(1), vessel)),
            {}};
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
