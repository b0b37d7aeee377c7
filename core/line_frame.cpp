#include "core/line_frame.hpp"

#include "core/error.hpp"
#include "core/line_points.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace braidzone {

namespace {

struct Mirror {
    Vec3 signs;
    const char* what;  ///< is done to the coordinates
    const char* why;
};

const Mirror mirrors[] = {
    {{1, 1, 1}, "", ""},
    {{-1, -1, 1},
     "with x and y negated",
     "one of the two is written in RAS and the other in LPS coordinates"},
    {{-1, 1, 1}, "with x negated", "x is mirrored in one of the two"},
    {{1, -1, 1}, "with y negated", "y is mirrored in one of the two"},
    {{1, 1, -1}, "with z negated", "z is mirrored in one of the two"},
};

constexpr double scales[] = {1.0, 10.0, 0.1, 1000.0, 1e-3, 25.4, 1.0 / 25.4};

/// Points at equal steps along a line, so that few points count like many.
std::vector<Vec3> evenly_along(const std::vector<Vec3>& points)
{
    constexpr int num_samples = 100;
    std::vector<double> length{0.0};
    for (std::size_t i = 1; i < points.size(); ++i)
        length.push_back(length.back() + (points[i] - points[i - 1]).norm());
    std::vector<Vec3> samples;
    std::size_t piece = 0;
    for (int k = 0; k < num_samples; ++k) {
        const double place = (k + 0.5) / num_samples * length.back();
        while (piece + 2 < points.size() && length[piece + 1] < place)
            ++piece;
        const double share = (place - length[piece]) / (length[piece + 1] - length[piece]);
        samples.push_back(points[piece] + share * (points[piece + 1] - points[piece]));
    }
    return samples;
}

double share_inside(const std::vector<Vec3>& points, const WallTree& wall)
{
    const auto inside = std::count_if(points.begin(), points.end(),
                                      [&](const Vec3& point) { return wall.contains(point); });
    return static_cast<double>(inside) / static_cast<double>(points.size());
}

/// Distance to the nearest opening, over its radius.
double to_an_opening(const Vec3& point, const std::vector<Opening>& openings)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Opening& opening : openings)
        least = std::min(least, (point - opening.centre).norm() / opening.radius);
    return least;
}

std::string words(const Mirror& mirror, double scale)
{
    std::string what = mirror.what, why = mirror.why;
    if (scale != 1.0) {
        const bool is_larger = scale > 1.0;
        what += fmt::format("{}{} by {:.6g}", what.empty() ? "" : " and ",
                            is_larger ? "multiplied" : "divided", is_larger ? scale : 1.0 / scale);
        why += fmt::format(
            "{}its unit of length is not that of the surface, and length_unit holds "
            "for both",
            why.empty() ? "" : ", and ");
    }
    return fmt::format("{} it lies in the lumen: {}", what, why);
}

}  // namespace

std::string fitting_frame(const std::vector<Vec3>& points, const Vessel& vessel,
                          const WallTree& wall)
{
    constexpr double least_share = 0.9;
    const std::vector<Vec3> samples = evenly_along(points);
    double best = std::numeric_limits<double>::infinity();
    std::string text;
    for (const Mirror& mirror : mirrors) {
        for (const double scale : scales) {
            const auto moved = [&](const Vec3& point) -> Vec3 {
                return scale * mirror.signs.cwiseProduct(point);
            };
            if (moved(points.back()) == points.back()) continue;
            std::vector<Vec3> in_frame;
            for (const Vec3& point : samples)
                in_frame.push_back(moved(point));
            if (!(share_inside(in_frame, wall) >= least_share)) continue;
            const double off = to_an_opening(moved(points.front()), vessel.openings) +
                               to_an_opening(moved(points.back()), vessel.openings);
            if (!text.empty() && !(off < best)) continue;
            best = off;
            text = words(mirror, scale);
        }
    }
    return text;
}

void require_same_frame(const std::vector<Polyline>& lines, const Vessel& vessel,
                        const WallTree& wall)
{
    constexpr double least_share = 0.5;
    double largest_share = 0.0;
    for (const Polyline& line : lines) {
        largest_share = std::max(largest_share, share_inside(evenly_along(line.points), wall));
        if (largest_share >= least_share) return;
    }
    const auto longest = std::max_element(
        lines.begin(), lines.end(),
        [](const Polyline& a, const Polyline& b) { return length_of(a) < length_of(b); });
    const std::string frame = fitting_frame(longest->points, vessel, wall);
    if (frame.empty() && largest_share > 0.0) return;
    throw GeometryError(fmt::format(
        "the centerline, from {} to {}, lies off the vessel; {}",
        place_text(longest->points.front(), vessel.unit),
        place_text(longest->points.back(), vessel.unit),
        frame.empty() ? "no change of signs or unit that is common would bring it there" : frame));
}

}  // namespace braidzone
