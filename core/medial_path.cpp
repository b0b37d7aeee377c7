#include "core/medial_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace braidzone {

namespace {

constexpr int num_rays = 64;
constexpr double unreached = std::numeric_limits<double>::infinity();

/// A cross-section of the lumen, in the plane of a frame.
struct LumenSection {
    CrossSection frame;
    std::array<double, num_rays> rays{};  ///< distance to the wall at each angle, or infinite [m]
    std::array<Vec2, num_rays> contour{};
    double radius = 0.0;    ///< of the vessel there [m]
    bool is_fixed = false;  ///< opens into something, or is an end: the path stays at the origin

    Vec3 place(const Vec2& offset) const
    {
        return frame.origin + offset.x() * frame.normal + offset.y() * frame.binormal;
    }
};

Vec2 ray_direction(int ray)
{
    const double angle = 2.0 * std::numbers::pi * ray / num_rays;
    return {std::cos(angle), std::sin(angle)};
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Median over a window of sections around one, of what `value` returns for each.
template <typename Value>
double median_around(const std::vector<LumenSection>& sections, int index, int reach,
                     const Value& value)
{
    const int n = static_cast<int>(sections.size());
    std::vector<double> window;
    for (int i = std::max(0, index - reach); i < std::min(n, index + reach + 1); ++i)
        window.push_back(value(sections[static_cast<std::size_t>(i)]));
    return median(std::move(window));
}

LumenSection measured_section(const CrossSection& frame, const WallTree& wall)
{
    LumenSection section;
    section.frame = frame;
    const double reach = 5.0 * frame.inscribed_radius;
    for (int ray = 0; ray < num_rays; ++ray) {
        const auto at = static_cast<std::size_t>(ray);
        const Vec2 direction = ray_direction(ray);
        const auto hit = wall.first_hit(frame.origin, section.place(reach * direction));
        section.rays[at] = hit ? hit->fraction * reach : unreached;
        section.contour[at] = (hit ? hit->fraction : 1.0) * reach * direction;
    }
    return section;
}

/// Marks the sections that open into a sac or a branch, and their neighbours.
void fix_open_sections(std::vector<LumenSection>& sections, double spacing, double mean_radius)
{
    constexpr double least_reach = 2.0;
    constexpr double least_growth = 1.3;
    const int n = static_cast<int>(sections.size());
    const int window = static_cast<int>(std::lround(4.0 * mean_radius / spacing));
    std::vector<bool> is_open(sections.size(), false);
    for (int i = 0; i < n; ++i) {
        LumenSection& section = sections[static_cast<std::size_t>(i)];
        section.radius = median_around(sections, i, window, [](const LumenSection& other) {
            return other.frame.inscribed_radius;
        });
        for (std::size_t ray = 0; ray < num_rays; ++ray) {
            if (!(section.rays[ray] > least_reach * section.radius)) continue;
            const double usual = median_around(
                sections, i, window, [&](const LumenSection& other) { return other.rays[ray]; });
            if (section.rays[ray] == unreached || section.rays[ray] > least_growth * usual)
                is_open[static_cast<std::size_t>(i)] = true;
        }
    }
    for (int i = 0; i < n; ++i) {
        LumenSection& section = sections[static_cast<std::size_t>(i)];
        const int margin = static_cast<int>(std::lround(section.radius / spacing));
        for (int k = std::max(0, i - margin); k < std::min(n, i + margin + 1); ++k)
            section.is_fixed = section.is_fixed || is_open[static_cast<std::size_t>(k)];
    }
    sections.front().is_fixed = true;
    sections.back().is_fixed = true;
}

/// Radius of the largest circle around a point of the section within its contour; 0 outside.
double inscribed_radius(const LumenSection& section, const Vec2& point)
{
    double nearest = unreached;
    bool is_inside = false;
    for (std::size_t k = 0; k < num_rays; ++k) {
        const Vec2& a = section.contour[k];
        const Vec2& b = section.contour[(k + 1) % num_rays];
        const Vec2 side = b - a, arm = point - a;
        const double share = std::clamp(arm.dot(side) / side.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (arm - share * side).squaredNorm());
        const bool crosses = (a.y() > point.y()) != (b.y() > point.y());
        if (crosses && arm.x() < side.x() * arm.y() / side.y()) is_inside = !is_inside;
    }
    return is_inside ? std::sqrt(nearest) : 0.0;
}

/// A place in a section that the path may go through.
struct Candidate {
    Vec2 offset = Vec2::Zero();
    Vec3 place = Vec3::Zero();
    double inverse_radius = 0.0;  ///< [1/m]
    double cost = unreached;      ///< of the best path to here
    int previous = -1;            ///< in the section before
};

std::vector<Candidate> candidates(const LumenSection& section, const Vec2& offset, double step)
{
    constexpr int steps_to_a_side = 2;
    const int reach = section.is_fixed ? 0 : steps_to_a_side;
    std::vector<Candidate> result;
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            Candidate candidate;
            candidate.offset = offset + step * section.radius * Vec2(i, j);
            const double radius = inscribed_radius(section, candidate.offset);
            if (!(radius > 0.0)) continue;
            candidate.place = section.place(candidate.offset);
            candidate.inverse_radius = 1.0 / radius;
            result.push_back(candidate);
        }
    }
    return result;
}

/// The offsets of least cost among places around the given ones.
std::vector<Vec2> improved(const std::vector<LumenSection>& sections,
                           const std::vector<Vec2>& offsets, double step)
{
    std::vector<std::vector<Candidate>> layers;
    for (std::size_t i = 0; i < sections.size(); ++i)
        layers.push_back(candidates(sections[i], offsets[i], step));
    for (Candidate& first : layers.front())
        first.cost = 0.0;
    for (std::size_t i = 1; i < layers.size(); ++i) {
        for (Candidate& here : layers[i]) {
            for (std::size_t k = 0; k < layers[i - 1].size(); ++k) {
                const Candidate& before = layers[i - 1][k];
                const double cost = before.cost + 0.5 * (here.place - before.place).norm() *
                                                      (here.inverse_radius + before.inverse_radius);
                if (!(cost < here.cost)) continue;
                here.cost = cost;
                here.previous = static_cast<int>(k);
            }
        }
    }
    std::vector<Vec2> best(offsets.size());
    int k = 0;  // the last section has one place
    for (std::size_t i = layers.size(); i-- > 0;) {
        const Candidate& candidate = layers[i][static_cast<std::size_t>(k)];
        best[i] = candidate.offset;
        k = candidate.previous;
    }
    return best;
}

std::vector<Vec2> least_cost_offsets(const std::vector<LumenSection>& sections)
{
    std::vector<Vec2> offsets(sections.size(), Vec2::Zero());
    constexpr double first_step = 0.16, last_step = 0.01;  // of the radius
    constexpr int most_moves = 20;
    for (double step = first_step; step >= last_step; step *= 0.5) {
        for (int move = 0; move < most_moves; ++move) {
            std::vector<Vec2> next = improved(sections, offsets, step);
            const bool rests = next == offsets;
            offsets = std::move(next);
            if (rests) break;
        }
    }
    return offsets;
}

std::vector<LumenSection> measured_sections(const Centerline& centerline, double mean_radius,
                                            const WallTree& wall)
{
    std::vector<LumenSection> sections;
    for (const CrossSection& frame : centerline.sections)
        sections.push_back(measured_section(frame, wall));
    fix_open_sections(sections, centerline.spacing, mean_radius);
    return sections;
}

Polyline with_wall_distances(std::vector<Vec3> points, const WallTree& wall)
{
    Polyline line;
    line.points = std::move(points);
    for (const Vec3& point : line.points)
        line.inscribed_radii.push_back(wall.nearest(point).distance);
    return line;
}

}  // namespace

Polyline medial_path(const Polyline& middle, const WallTree& wall)
{
    const double mean_radius =
        std::accumulate(middle.inscribed_radii.begin(), middle.inscribed_radii.end(), 0.0) /
        static_cast<double>(middle.inscribed_radii.size());
    const double spacing = mean_radius / 6.0;
    const Centerline centerline = resample(middle, {.spacing = spacing, .smoothing = 0.0});
    const std::vector<LumenSection> sections = measured_sections(centerline, mean_radius, wall);
    const std::vector<Vec2> offsets = least_cost_offsets(sections);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Vec3 place = sections[i].place(offsets[i]);
        const Vec3& origin = sections[i].frame.origin;
        points.push_back(wall.first_hit(origin, place) ? origin : place);
    }
    const Centerline smooth = resample(with_wall_distances(std::move(points), wall),
                                       {.spacing = spacing, .smoothing = 0.5});
    std::vector<Vec3> smooth_points;
    for (const CrossSection& section : smooth.sections)
        smooth_points.push_back(section.origin);
    smooth_points.front() = middle.points.front();
    smooth_points.back() = middle.points.back();
    return with_wall_distances(std::move(smooth_points), wall);
}

}  // namespace braidzone
