#include "deploy/wall_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Directions in which each section looks for the wall.
constexpr int num_directions = 48;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Between the closed sections on both sides of an open one, direction by direction.
WallProfile between(const WallProfile& first, const WallProfile& second, double share)
{
    WallProfile profile;
    for (std::size_t i = 0; i < first.size(); ++i)
        profile.push_back((1.0 - share) * first[i] + share * second[i]);
    return profile;
}

}  // namespace

double angle_about_hub(const CrossSection& section, const Vec3& point)
{
    const Vec3 from_hub = point - section.origin;
    return std::atan2(from_hub.dot(section.binormal), from_hub.dot(section.normal));
}

Vec3 direction_at(const CrossSection& section, double angle)
{
    return std::cos(angle) * section.normal + std::sin(angle) * section.binormal;
}

double distance_to_wall(const WallTree& wall, const Vec3& hub, const Vec3& direction, double reach)
{
    const std::optional<WallHit> hit = wall.first_hit(hub, hub + reach * direction);
    return hit ? hit->fraction * reach : reach;
}

WallProfile wall_profile(const WallTree& wall, const CrossSection& section, double reach)
{
    WallProfile profile;
    for (int i = 0; i < num_directions; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / num_directions;
        profile.push_back(
            distance_to_wall(wall, section.origin, direction_at(section, angle), reach));
    }
    return profile;
}

double lower_quartile(WallProfile profile)
{
    const auto quartile = profile.begin() + num_directions / 4;
    std::nth_element(profile.begin(), quartile, profile.end());
    return *quartile;
}

double at_angle(const WallProfile& profile, double angle)
{
    const double place = angle / (2.0 * std::numbers::pi) * num_directions;
    const double before = std::floor(place);
    const int first = (static_cast<int>(before) % num_directions + num_directions) % num_directions;
    const double share = place - before;
    return (1.0 - share) * profile[index(first)] +
           share * profile[index((first + 1) % num_directions)];
}

std::vector<char> open_sections(const std::vector<double>& places,
                                const std::vector<WallProfile>& profiles, double opening_ratio)
{
    std::vector<char> open(profiles.size(), 0);
    for (std::size_t section = 0; section < profiles.size(); ++section) {
        const WallProfile& profile = profiles[section];
        const double tube = lower_quartile(profile);
        if (!(*std::max_element(profile.begin(), profile.end()) > opening_ratio * tube)) continue;
        for (std::size_t other = 0; other < profiles.size(); ++other) {
            if (std::abs(places[other] - places[section]) <= tube) open[other] = 1;
        }
    }
    return open;
}

std::vector<WallProfile> parent_profiles(const std::vector<double>& places,
                                         const std::vector<WallProfile>& profiles,
                                         const std::vector<char>& open)
{
    const int num_sections = static_cast<int>(profiles.size());
    std::vector<WallProfile> parents = profiles;
    for (int section = 0; section < num_sections; ++section) {
        if (!open[index(section)]) continue;
        int before = section, after = section;
        while (before >= 0 && open[index(before)])
            --before;
        while (after < num_sections && open[index(after)])
            ++after;
        WallProfile& parent = parents[index(section)];
        if (before < 0 && after == num_sections) {
            parent.assign(num_directions, lower_quartile(profiles[index(section)]));
        } else if (before < 0) {
            parent = profiles[index(after)];
        } else if (after == num_sections) {
            parent = profiles[index(before)];
        } else {
            const double share = (places[index(before)] - places[index(section)]) /
                                 (places[index(before)] - places[index(after)]);
            parent = between(profiles[index(before)], profiles[index(after)], share);
        }
    }
    return parents;
}

}  // namespace braidzone
