#include "deploy/ring_centring.hpp"

#include <Eigen/QR>

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
/// Last step over the nominal radius: 0.02 nm for 4 mm.
constexpr double tolerance_ratio = 1e-8;
constexpr int most_rounds = 50;

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

/// Twice the energy of the springs, for a stiffness of one each [m^2]: convex in the hub's place d.
double energy_of(const Vec2& middle, const Distances& walls, const Directions& directions,
                 double reach)
{
    double energy = 0.0;
    for (std::size_t i = 0; i < walls.size(); ++i)
        energy += std::pow(std::max(0.0, reach + middle.dot(directions[i]) - walls[i]), 2);
    return energy;
}

/// The middle, where the springs are in balance: the least of their energy, by Newton's method with
/// steps that are halved until they lower it. Each step is exact as long as the same directions end
/// on the wall.
Vec2 middle_of(const Distances& walls, const Directions& directions, double reach, double tolerance)
{
    Vec2 middle = Vec2::Zero();
    for (int round = 0; round < most_rounds; ++round) {
        Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
        Vec2 force = Vec2::Zero();
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const double squeeze = reach + middle.dot(directions[i]) - walls[i];
            if (!(squeeze > 0.0)) continue;
            stiffness += directions[i] * directions[i].transpose();
            force -= squeeze * directions[i];
        }
        Vec2 step = stiffness.completeOrthogonalDecomposition().solve(force);
        const double before = energy_of(middle, walls, directions, reach);
        while (step.norm() > tolerance &&
               energy_of(middle + step, walls, directions, reach) > before)
            step *= 0.5;
        middle += step;
        if (step.norm() <= tolerance) break;
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
