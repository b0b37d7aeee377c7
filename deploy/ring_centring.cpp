#include "deploy/ring_centring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Directions in a cross-section: when one of them passes from the wall into a sac, the middle
/// moves by 2 / 96 of the gap between wall and reach.
constexpr int num_directions = 96;
/// Distance of the stations over the nominal radius: four in a standard deviation of the smoothing.
constexpr double station_spacing_ratio = 0.125;
constexpr double smoothing_ratio = 0.5;
/// Reach over the inscribed radius, see the header.
constexpr double reach_ratio = 1.2;
/// How far walls are looked for, over the reach: more than the reach and the way of a hub.
constexpr double sight_ratio = 2.0;
/// The middle is found to within this fraction of the nominal radius: 0.02 um for 4 mm.
constexpr double tolerance_ratio = 1e-5;
constexpr int most_iterations = 500;

using Directions = std::array<Vec2, num_directions>;
using Distances = std::array<double, num_directions>;

Directions directions_around()
{
    Directions all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / num_directions;
        all[i] = Vec2(std::cos(angle), std::sin(angle));
    }
    return all;
}

/// Distances of the wall from the centerline [m]; `sight` where there is none nearer.
Distances wall_distances(const CrossSection& section, const WallTree& wall,
                         const Directions& directions, double sight)
{
    Distances distances;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Vec3 ray = directions[i][0] * section.normal + directions[i][1] * section.binormal;
        const std::optional<WallHit> hit =
            wall.first_hit(section.origin, section.origin + sight * ray);
        distances[i] = (hit ? hit->fraction : 1.0) * sight;
    }
    return distances;
}

/// The middle d = 2 <min(w, reach + d . e) e>, w the wall's distances, e the directions. It is a
/// fixed point found with Anderson's acceleration of depth one (Walker and Ni 2011, doi
/// 10.1137/10078356X), as plain steps close on it slowly where few directions end on the wall. A
/// way that has become longer starts it anew.
Vec2 middle_of(const Distances& walls, const Directions& directions, double reach, double tolerance)
{
    const auto way_from = [&](const Vec2& middle) {
        Vec2 sum = Vec2::Zero();
        for (std::size_t i = 0; i < walls.size(); ++i)
            sum += std::min(walls[i], reach + middle.dot(directions[i])) * directions[i];
        return Vec2(2.0 / num_directions * sum - middle);
    };
    Vec2 middle = Vec2::Zero(), last_middle = middle;
    Vec2 way = way_from(middle), last_way = way;
    for (int iteration = 0; iteration < most_iterations && way.norm() >= tolerance; ++iteration) {
        const Vec2 change = way - last_way;
        const bool accelerates = iteration > 0 && way.norm() < last_way.norm();
        const double share = accelerates ? way.dot(change) / change.squaredNorm() : 0.0;
        const Vec2 next = middle + way - share * (middle - last_middle + change);
        last_middle = middle;
        last_way = way;
        middle = next;
        way = way_from(middle);
    }
    return middle;
}

/// In-plane shift from the centerline to the middle [m], in the section's normal and binormal.
Vec2 centring_shift(const CrossSection& section, const WallTree& wall, double nominal_radius)
{
    static const Directions directions = directions_around();
    const double reach = std::min(nominal_radius, reach_ratio * section.inscribed_radius);
    return middle_of(wall_distances(section, wall, directions, sight_ratio * reach), directions,
                     reach, tolerance_ratio * nominal_radius);
}

}  // namespace

std::vector<CrossSection> centred_rings(const Centerline& centerline, const WallTree& wall,
                                        const std::vector<double>& arc_lengths,
                                        double nominal_radius)
{
    const auto [proximal, distal] = std::minmax_element(arc_lengths.begin(), arc_lengths.end());
    const double length = *distal - *proximal;
    const int num_gaps =
        std::max(1, static_cast<int>(std::ceil(length / (station_spacing_ratio * nominal_radius))));
    std::vector<double> stations;
    std::vector<Vec2> shifts;
    for (int i = 0; i <= num_gaps; ++i) {
        stations.push_back(std::min(*proximal + length * i / num_gaps, *distal));
        shifts.push_back(
            centring_shift(section_at(centerline, stations.back()), wall, nominal_radius));
    }

    std::vector<CrossSection> rings;
    for (double arc_length : arc_lengths) {
        Vec2 sum = Vec2::Zero();
        double weights = 0.0;
        for (std::size_t i = 0; i < stations.size(); ++i) {
            const double u = (stations[i] - arc_length) / (smoothing_ratio * nominal_radius);
            const double weight = std::exp(-0.5 * u * u);
            sum += weight * shifts[i];
            weights += weight;
        }
        const Vec2 shift = sum / weights;
        CrossSection ring = section_at(centerline, arc_length);
        ring.origin += shift[0] * ring.normal + shift[1] * ring.binormal;
        rings.push_back(ring);
    }
    return rings;
}

}  // namespace braidzone
