#include "deploy/lumen_tube.hpp"

#include "core/lumen_path.hpp"
#include "core/path_centring.hpp"
#include "deploy/neck.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace braidzone {

namespace {

/// With what opens into the tube taken out of its profiles.
LumenTube closed(std::vector<CrossSection> sections, const std::vector<double>& places,
                 const std::vector<WallProfile>& profiles)
{
    return {std::move(sections),
            parent_profiles(places, profiles,
                            open_sections(places, profiles, NeckOptions{}.opening_ratio))};
}

}  // namespace

LumenTube tube_along(const WallTree& wall, const Centerline& centerline, double reach)
{
    double sum = 0.0;
    for (const CrossSection& section : centerline.sections)
        sum += section.inscribed_radius;
    const double mean_radius = sum / static_cast<double>(centerline.sections.size());
    const auto stride = static_cast<std::size_t>(
        std::max(1.0, std::round(0.25 * mean_radius / centerline.spacing)));
    std::vector<CrossSection> sections;
    std::vector<double> places;
    std::vector<WallProfile> profiles;
    for (std::size_t i = 0; i < centerline.sections.size(); i += stride) {
        sections.push_back(centerline.sections[i]);
        places.push_back(static_cast<double>(i) * centerline.spacing);
        profiles.push_back(wall_profile(wall, centerline.sections[i], reach));
    }
    return closed(std::move(sections), places, profiles);
}

LumenTube branch_tube(const WallTree& wall, const Opening& opening, const Vec3& hub,
                      const LumenTube& parent, double reach)
{
    constexpr double points_per_radius = 3.0;
    const double spacing = opening.radius / points_per_radius;
    const Vec3 start = opening.centre - spacing * opening.normal;
    if (!wall.contains(start) || !wall.contains(hub)) return {};
    const std::vector<Vec3> path = least_cost_path(wall, start, hub, opening.radius, spacing);
    if (path.size() < 2) return {};
    const LumenTube whole = tube_along(wall, resample(centred_path(path, wall)), reach);
    LumenTube tube;
    for (std::size_t i = 0; i < whole.sections.size(); ++i) {
        if (relative_distance(parent, whole.sections[i].origin) < 1.0) continue;
        tube.sections.push_back(whole.sections[i]);
        tube.radii.push_back(whole.radii[i]);
    }
    return tube;
}

double relative_distance(const LumenTube& tube, const Vec3& point)
{
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tube.sections.size(); ++i) {
        const double distance = (tube.sections[i].origin - point).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    const CrossSection& section = tube.sections[nearest];
    return std::sqrt(least) / at_angle(tube.radii[nearest], angle_about_hub(section, point));
}

}  // namespace braidzone
