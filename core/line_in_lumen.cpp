#include "core/line_in_lumen.hpp"

#include "core/cubic_spline.hpp"
#include "core/error.hpp"
#include "core/lumen_path.hpp"
#include "core/path_centring.hpp"
#include "core/place_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace braidzone {

namespace {

constexpr double most_shift = 0.5;  ///< of the radius

/// Points of a line without those that repeat their predecessor, which a spline cannot have.
Polyline without_repeats(const Polyline& line)
{
    Polyline distinct;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        if (i > 0 && line.points[i] == distinct.points.back()) continue;
        distinct.points.push_back(line.points[i]);
        if (!line.inscribed_radii.empty())
            distinct.inscribed_radii.push_back(line.inscribed_radii[i]);
    }
    return distinct;
}

std::vector<Vec3> samples_of_piece(const CubicSpline& spline, int piece, int num_intervals)
{
    std::vector<Vec3> samples;
    for (int k = 0; k <= num_intervals; ++k)
        samples.push_back(point_at(spline, {piece, static_cast<double>(k) / num_intervals}));
    return samples;
}

std::vector<Vec3> samples_of_segment(const Vec3& from, const Vec3& to, int num_intervals)
{
    std::vector<Vec3> samples;
    for (int k = 0; k <= num_intervals; ++k)
        samples.push_back(from + static_cast<double>(k) / num_intervals * (to - from));
    return samples;
}

std::optional<WallHit> first_hit_along(const std::vector<Vec3>& path, const WallTree& wall)
{
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        if (auto hit = wall.first_hit(path[k], path[k + 1])) return hit;
    }
    return std::nullopt;
}

double distance_to(const std::vector<Vec3>& curve, const Vec3& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
        const Vec3 chord = curve[k + 1] - curve[k];
        const double share =
            std::clamp((point - curve[k]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (curve[k] + share * chord - point).norm());
    }
    return nearest;
}

class Laying {
public:
    Laying(const Polyline& line, const WallTree& wall) : line_(without_repeats(line)), wall_(wall)
    {
    }

    LineInLumen result() &&
    {
        // Points that are put in change the spline beside them, by less with each round.
        constexpr int most_rounds = 4;
        bool has_changed = true;
        for (int round = 0; round < most_rounds && has_changed; ++round)
            has_changed = lay_once();
        return {std::move(line_), std::move(recentred_)};
    }

private:
    bool lay_once()
    {
        const CubicSpline spline = fit_spline(line_.points);
        Polyline laid;
        bool has_changed = false;
        for (std::size_t i = 0; i + 1 < line_.points.size(); ++i) {
            append(laid, i);
            for (const Vec3& point : points_between(spline, i)) {
                has_changed = true;
                laid.points.push_back(point);
                if (!line_.inscribed_radii.empty())
                    laid.inscribed_radii.push_back(wall_.nearest(point).distance);
            }
        }
        append(laid, line_.points.size() - 1);
        line_ = std::move(laid);
        return has_changed;
    }

    void append(Polyline& laid, std::size_t i) const
    {
        laid.points.push_back(line_.points[i]);
        if (!line_.inscribed_radii.empty())
            laid.inscribed_radii.push_back(line_.inscribed_radii[i]);
    }

    /// What is to be put in between two points; nothing if the path between them is good.
    std::vector<Vec3> points_between(const CubicSpline& spline, std::size_t i)
    {
        const Vec3 &from = line_.points[i], &to = line_.points[i + 1];
        const double radius = std::max(wall_.nearest(from).distance, wall_.nearest(to).distance);
        constexpr double most_intervals = 200.0;
        const double length = (to - from).norm();
        const int num_intervals =
            static_cast<int>(std::clamp(std::ceil(4.0 * length / radius), 1.0, most_intervals));
        const std::vector<Vec3> curve =
            samples_of_piece(spline, static_cast<int>(i), std::max(num_intervals, 4));
        if (const auto hit = wall_.first_hit(from, to)) return middle_between(i, *hit, curve);
        if (!first_hit_along(curve, wall_)) return {};
        std::vector<Vec3> points = samples_of_segment(from, to, std::max(num_intervals, 2));
        return {points.begin() + 1, points.end() - 1};
    }

    std::vector<Vec3> middle_between(std::size_t i, const WallHit& hit,
                                     const std::vector<Vec3>& curve)
    {
        const Vec3 &from = line_.points[i], &to = line_.points[i + 1];
        const std::string what =
            fmt::format("between {} and {} the centerline passes through the wall, at {}",
                        place_text(from), place_text(to), place_text(hit.point));
        const double radius = std::max(wall_.nearest(from).distance, wall_.nearest(to).distance);
        constexpr double points_per_radius = 6.0;
        const std::vector<Vec3> path =
            least_cost_path(wall_, from, to, radius, radius / points_per_radius);
        if (path.size() < 3)
            throw GeometryError(fmt::format("{}, and no path through the lumen joins them", what));
        const Polyline middle = centred_path(path, wall_);
        RecentredPart part{hit.point, 0.0, 0.0};
        for (std::size_t k = 0; k < middle.points.size(); ++k) {
            const double shift = std::min(distance_to(curve, middle.points[k]),
                                          distance_to({from, to}, middle.points[k]));
            part.largest_shift = std::max(part.largest_shift, shift);
            part.share = std::max(part.share, shift / middle.inscribed_radii[k]);
        }
        if (!(part.share <= most_shift)) {
            throw GeometryError(fmt::format(
                "{}; the middle of the lumen is up to {:.3g} mm off the line there, {:.3g} of its "
                "radius (at most {} is re-centred)",
                what, 1e3 * part.largest_shift, part.share, most_shift));
        }
        recentred_.push_back(part);
        return {middle.points.begin() + 1, middle.points.end() - 1};
    }

    Polyline line_;
    const WallTree& wall_;
    std::vector<RecentredPart> recentred_;
};

}  // namespace

LineInLumen with_path_in_lumen(const Polyline& line, const WallTree& wall)
{
    return Laying(line, wall).result();
}

}  // namespace braidzone
