#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

#include <vector>

namespace braidzone {

// The parent vessel as seen from the hubs of cross-sections.

/// Distances from the hub of a section to the wall in 48 directions of its plane, evenly spaced
/// from the section's normal towards its binormal [m].
using WallProfile = std::vector<double>;

/// Angle of a point about a section's hub, from its normal towards its binormal [rad].
double angle_about_hub(const CrossSection& section, const Vec3& point);

/// Unit vector in a section's plane at such an angle.
Vec3 direction_at(const CrossSection& section, double angle);

/// From a hub to the wall in a direction [m]; `reach` if the wall is no nearer than that.
/// @param direction  unit
double distance_to_wall(const WallTree& wall, const Vec3& hub, const Vec3& direction, double reach);

WallProfile wall_profile(const WallTree& wall, const CrossSection& section, double reach);

/// Radius of the tube in which a section lies: a quarter of the directions see the wall nearer [m].
double lower_quartile(WallProfile profile);

/// The value of a profile in any direction, linear between two of its directions [m].
double at_angle(const WallProfile& profile, double angle);

/// For each section, 1 if it looks into an opening, or is beside one that does (`find_openings`).
/// @param places  arc lengths of the sections, all increasing or all decreasing [m]
std::vector<char> open_sections(const std::vector<double>& places,
                                const std::vector<WallProfile>& profiles, double opening_ratio);

/// The parent vessel's wall as each section would see it without the openings (`find_openings`).
std::vector<WallProfile> parent_profiles(const std::vector<double>& places,
                                         const std::vector<WallProfile>& profiles,
                                         const std::vector<char>& open);

}  // namespace braidzone
