#include "core/given_centerline.hpp"

#include "core/centerline_compute.hpp"
#include "core/line_choice.hpp"
#include "core/line_ends.hpp"
#include "core/line_frame.hpp"
#include "core/line_in_lumen.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <utility>

namespace braidzone {

namespace {

std::string length_text(double length, const LengthUnit& unit)
{
    return fmt::format("{:.3g} {}", length / unit.metres, unit.name);
}

std::string end_text(const LineEnd& end, const Vec3& point, const LengthUnit& unit)
{
    if (end.opening >= 0) return fmt::format("opening {}", end.opening);
    return place_text(point, unit);
}

}  // namespace

GivenCenterline given_centerline(const std::vector<Polyline>& lines, const Vessel& vessel,
                                 const WallTree& wall, const LineChoice& choice)
{
    require_same_frame(lines, vessel, wall);
    const ChosenLine chosen = chosen_line(lines, vessel, wall, choice);
    TrimmedLine trimmed = trimmed_at_openings(chosen.line, vessel, wall);
    LineInLumen laid = with_path_in_lumen(trimmed.line, wall);

    GivenCenterline given;
    const std::string from = end_text(trimmed.first, trimmed.line.points.front(), vessel.unit);
    const std::string to = end_text(trimmed.last, trimmed.line.points.back(), vessel.unit);
    if (chosen.num_others > 0) {
        given.notes.push_back(
            fmt::format("the centerline is the one from {} to {}; the file holds {} other line{}, "
                        "of branches",
                        from, to, chosen.num_others, chosen.num_others == 1 ? "" : "s"));
    }
    const auto note_trimmed = [&](const LineEnd& end, const char* name, const std::string& place) {
        if (!(end.trimmed > 0.0)) return;
        given.notes.push_back(fmt::format("trimmed {} of the centerline's {} end, beyond {}",
                                          length_text(end.trimmed, vessel.unit), name, place));
    };
    note_trimmed(trimmed.first, "proximal", from);
    note_trimmed(trimmed.last, "distal", to);
    for (const RecentredPart& part : laid.recentred) {
        given.notes.push_back(fmt::format(
            "the centerline passed through the wall at {}; it is re-centred there, by up to {}, "
            "{:.2g} of the radius",
            place_text(part.place, vessel.unit), length_text(part.largest_shift, vessel.unit),
            part.share));
    }
    given.line = with_inscribed_radii(laid.line, wall);
    return given;
}

}  // namespace braidzone
