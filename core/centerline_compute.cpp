#include "core/centerline_compute.hpp"

#include "core/error.hpp"
#include "core/lumen_path.hpp"
#include "core/medial_path.hpp"
#include "core/path_centring.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

/// One end of the search.
struct PathEnd {
    Vec3 start = Vec3::Zero();   ///< in the lumen [m]
    double parent_radius = 0.0;  ///< what is known of the parent vessel's radius there [m]
};

/// An end on an opening starts a step inwards; the opening's radius is the parent vessel's. Away
/// from the openings, where a sac could deceive, the largest opening stands for it.
PathEnd path_end(const Vessel& vessel, const WallTree& wall, const Vec3& point, double step,
                 const char* name)
{
    for (const Opening& opening : vessel.openings) {
        const Vec3 offset = point - opening.centre;
        const double along = offset.dot(opening.normal);
        const double across = (offset - along * opening.normal).norm();
        // An oval opening reaches farther than its mean radius.
        if (std::abs(along) > step || across > 2.0 * opening.radius) continue;
        const Vec3 inwards = point - (along + step) * opening.normal;
        if (wall.contains(inwards)) return {inwards, opening.radius};
    }
    if (!point.allFinite() || !wall.contains(point)) {
        throw GeometryError(fmt::format("the centerline's {} point {} lies outside the lumen", name,
                                        place_text(point)));
    }
    return {point, vessel.openings.front().radius};
}

}  // namespace

Polyline compute_centerline(const Vessel& vessel, const WallTree& wall, const Vec3& from,
                            const Vec3& to, const CenterlineOptions& options)
{
    if (!(options.points_per_radius >= 1.0 && options.points_per_radius <= 100.0)) {
        throw InputError(fmt::format("points_per_radius = {:.6g}; allowed are 1 to 100",
                                     options.points_per_radius));
    }
    const auto narrowest =
        std::min_element(vessel.openings.begin(), vessel.openings.end(),
                         [](const Opening& a, const Opening& b) { return a.radius < b.radius; });
    const double spacing = narrowest->radius / options.points_per_radius;
    const PathEnd first = path_end(vessel, wall, from, spacing, "first");
    const PathEnd last = path_end(vessel, wall, to, spacing, "last");
    if ((first.start - last.start).norm() <= spacing) {
        throw GeometryError(
            fmt::format("the centerline's first and last point, {} and {}, are at one place",
                        place_text(from), place_text(to)));
    }
    const double cap = std::max(first.parent_radius, last.parent_radius);
    std::vector<Vec3> path = least_cost_path(wall, first.start, last.start, cap, spacing);
    if (path.empty()) {
        throw GeometryError(
            fmt::format("no path through the lumen joins {} and {} on a grid of {:.6g} mm",
                        place_text(from), place_text(to), 1e3 * spacing));
    }
    path.front() = from;
    path.back() = to;
    return with_inscribed_radii(medial_path(centred_path(path, wall), wall), wall);
}

Polyline with_inscribed_radii(const Polyline& polyline, const WallTree& wall)
{
    Polyline result = polyline;
    const std::size_t n = polyline.points.size();
    int num_outside = 0;
    std::size_t first_outside = 0;
    std::vector<double> distances;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3& point = polyline.points[i];
        distances.push_back(wall.nearest(point).distance);
        bool is_inside = wall.contains(point);
        const bool is_end = i == 0 || i + 1 == n;
        if (!is_inside && is_end && n > 1) {
            // An end on an opening is a rounding error outside: look a hundredth of the radius on.
            const Vec3& neighbour = polyline.points[i == 0 ? 1 : n - 2];
            const Vec3 inwards = (neighbour - point).normalized();
            is_inside = wall.contains(point + 0.01 * distances.back() * inwards);
        }
        if (!is_inside) {
            if (num_outside == 0) first_outside = i;
            ++num_outside;
        }
    }
    if (num_outside > 0) {
        throw GeometryError(fmt::format(
            "{} of the centerline's {} points lie outside the lumen; the first is point {} at {}",
            num_outside, n, first_outside, place_text(polyline.points[first_outside])));
    }
    if (result.inscribed_radii.empty()) result.inscribed_radii = distances;
    return result;
}

}  // namespace braidzone
