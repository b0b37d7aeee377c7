#include "deploy/ring_centring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Directions in a cross-section: when one of them passes from the wall into a sac, the middle
/// moves by 2 / 48 of the gap between wall and reach.
constexpr int num_directions = 48;
/// Distance of the stations over the nominal radius: four in a standard deviation of the smoothing.
constexpr double station_spacing_ratio = 0.125;
constexpr double smoothing_ratio = 0.5;
/// Reach over the inscribed radius, see the header.
constexpr double reach_ratio = 1.1;
/// The middle is found to within this fraction of the nominal radius: 0.02 um for 4 mm.
constexpr double tolerance_ratio = 1e-5;
constexpr int most_iterations = 50;

/// Twice the mean of min(wall distance, reach) e over the directions around a hub: to first order,
/// the way from the hub to the middle of a circle [m].
Vec2 way_to_middle(const CrossSection& section, const Vec2& shift, const WallTree& wall,
                   double reach)
{
    const Vec3 hub = section.origin + shift[0] * section.normal + shift[1] * section.binormal;
    Vec2 sum = Vec2::Zero();
    for (int i = 0; i < num_directions; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / num_directions;
        const Vec2 direction(std::cos(angle), std::sin(angle));
        const Vec3 ray = direction[0] * section.normal + direction[1] * section.binormal;
        const std::optional<WallHit> hit = wall.first_hit(hub, hub + reach * ray);
        sum += (hit ? hit->fraction : 1.0) * reach * direction;
    }
    return 2.0 / num_directions * sum;
}

/// In-plane shift from the centerline to the middle [m], in the section's normal and binormal: the
/// fixed point of shift + way, with Anderson's acceleration of depth one (Walker and Ni 2011, doi
/// 10.1137/10078356X), as plain steps close on it by a seventh each in front of a neck. A way that
/// has become longer starts it anew.
Vec2 centring_shift(const CrossSection& section, const WallTree& wall, double nominal_radius)
{
    const double reach = std::min(nominal_radius, reach_ratio * section.inscribed_radius);
    Vec2 shift = Vec2::Zero(), last_shift = shift;
    Vec2 way = way_to_middle(section, shift, wall, reach), last_way = way;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        if (way.norm() < tolerance_ratio * nominal_radius) break;
        const Vec2 change = way - last_way;
        const bool accelerates = iteration > 0 && way.norm() < last_way.norm();
        const double share = accelerates ? way.dot(change) / change.squaredNorm() : 0.0;
        const Vec2 next = shift + way - share * (shift - last_shift + change);
        last_shift = shift;
        last_way = way;
        shift = next;
        way = way_to_middle(section, shift, wall, reach);
    }
    return shift;
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
