#include "core/path_centring.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace braidzone {

namespace {

constexpr int num_rays = 32;

/// Radii of the parent vessel along the path: the running median, over `reach` samples to either
/// side, of the wall distances. Neither the bump of a sac nor a place where the path still lies
/// off centre shows in it.
std::vector<double> running_median(const std::vector<double>& distances, int reach)
{
    const int n = static_cast<int>(distances.size());
    std::vector<double> medians;
    for (int i = 0; i < n; ++i) {
        std::vector<double> window(distances.begin() + std::max(0, i - reach),
                                   distances.begin() + std::min(n, i + reach + 1));
        const auto middle = window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2);
        std::nth_element(window.begin(), middle, window.end());
        medians.push_back(*middle);
    }
    return medians;
}

/// Where rays in the plane of the section meet the wall, from its origin along normal and binormal.
std::vector<Vec2> wall_around(const CrossSection& section, const WallTree& wall, double reach)
{
    std::vector<Vec2> points;
    for (int ray = 0; ray < num_rays; ++ray) {
        const double angle = 2.0 * std::numbers::pi * ray / num_rays;
        const Vec2 direction(std::cos(angle), std::sin(angle));
        const Vec3 end = section.origin + reach * (direction.x() * section.normal +
                                                   direction.y() * section.binormal);
        const auto hit = wall.first_hit(section.origin, end);
        if (hit) points.push_back(hit->fraction * reach * direction);
    }
    return points;
}

// Weights of the last two terms of the fit below, against 1 for a point of the wall.
constexpr double weight_of_radius = 0.1;
constexpr double weight_of_place = 0.3;

/// Centre of the circle |x - c| = r through most of the points: minimises
///
///     sum_j w_j (|x_j - c| - r)^2 + num_rays (0.1 (r - r0)^2 + 0.3 |c|^2)
///
/// by Gauss-Newton steps. A point within the circle has weight 1, one outside Tukey's
/// (1 - (e / s)^2)^2 up to e = s; s shrinks from r0 to r0 / 4 to find the right part of the wall
/// first. The last two terms decide where too little of the wall is left: the path stays where its
/// neighbours smooth it to. Where the wall is whole they only slow the path's approach.
Vec2 circle_centre(const std::vector<Vec2>& points, double expected_radius)
{
    constexpr int num_steps = 12;
    const Vec3 prior_weights = num_rays * Vec3(weight_of_place, weight_of_place, weight_of_radius);
    const Vec3 prior(0.0, 0.0, expected_radius);
    Vec3 circle = prior;  // centre and radius
    for (int step = 0; step < num_steps; ++step) {
        const double scale = expected_radius * std::max(0.25, 1.0 - 1.5 * step / num_steps);
        Mat3 matrix = prior_weights.asDiagonal();
        Vec3 right = prior_weights.cwiseProduct(prior - circle);
        for (const Vec2& point : points) {
            const Vec2 arm = point - circle.head<2>();
            const double excess = arm.norm() - circle.z();
            const double inlier = std::max(0.0, 1.0 - (excess * excess) / (scale * scale));
            const double weight = excess > 0.0 ? inlier * inlier : 1.0;
            const Vec2 outwards = arm.normalized();
            const Vec3 slope(outwards.x(), outwards.y(), 1.0);
            matrix += weight * slope * slope.transpose();
            right += weight * excess * slope;
        }
        circle += matrix.ldlt().solve(right);
    }
    return circle.head<2>();
}

Polyline with_wall_distances(std::vector<Vec3> points, const WallTree& wall)
{
    Polyline line;
    line.points = std::move(points);
    for (const Vec3& point : line.points) {
        line.inscribed_radii.push_back(wall.nearest(point).distance);
    }
    return line;
}

std::vector<Vec3> origins(const Centerline& centerline)
{
    std::vector<Vec3> points;
    for (const CrossSection& section : centerline.sections)
        points.push_back(section.origin);
    return points;
}

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Polyline centred_path(const std::vector<Vec3>& path, const WallTree& wall)
{
    Polyline line = with_wall_distances(path, wall);
    const double mean_radius = mean(line.inscribed_radii);
    // The grid's steps are rough: the first smoothing is stronger.
    ResampleOptions resampling{.spacing = mean_radius / 6.0, .smoothing = 1.0};
    constexpr int max_rounds = 20;
    for (int round = 0; round < max_rounds; ++round) {
        const Centerline centerline = resample(line, resampling);
        resampling.smoothing = 0.5;
        line = with_wall_distances(origins(centerline), wall);
        const std::vector<double> radii =
            running_median(line.inscribed_radii,
                           static_cast<int>(std::lround(4.0 * mean_radius / centerline.spacing)));
        double largest_shift = 0.0;
        for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {
            const CrossSection& section = centerline.sections[i];
            const double radius = radii[i];
            const Vec2 centre = circle_centre(wall_around(section, wall, 3.0 * radius), radius);
            const Vec2 shift =
                centre * std::min(1.0, 0.5 * radius / std::max(centre.norm(), 1e-3 * radius));
            const Vec3 moved =
                section.origin + shift.x() * section.normal + shift.y() * section.binormal;
            if (wall.first_hit(section.origin, moved)) continue;
            line.points[i] = moved;
            largest_shift = std::max(largest_shift, shift.norm() / radius);
        }
        if (largest_shift < 2e-3) break;
    }
    std::vector<Vec3> points = origins(resample(line, resampling));
    points.front() = path.front();
    points.back() = path.back();
    return with_wall_distances(std::move(points), wall);
}

}  // namespace braidzone
