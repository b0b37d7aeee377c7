#include "deploy/hub_shift.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

constexpr int num_directions = 24;
/// Beyond the nominal radius, over it: the distance of the wall at which a direction is all open.
constexpr double open_ratio = 0.5;
constexpr double smoothing_ratio = 0.5;
/// |o| of a ring that moves by the whole shift: 2 / pi sin(pi / 8) = 0.24 is that of an eighth of
/// the circumference.
constexpr double least_openness = 0.2;

Vec3 open_side(const CrossSection& ring, const WallTree& wall, double nominal_radius)
{
    const double reach = (1.0 + open_ratio) * nominal_radius;
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < num_directions; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / num_directions;
        const Vec3 ray = std::cos(angle) * ring.normal + std::sin(angle) * ring.binormal;
        const std::optional<WallHit> hit = wall.first_hit(ring.origin, ring.origin + reach * ray);
        const double distance = (hit ? hit->fraction : 1.0) * reach;
        const double beyond = (distance - nominal_radius) / (open_ratio * nominal_radius);
        sum += std::clamp(beyond, 0.0, 1.0) * ray;
    }
    return 2.0 / num_directions * sum;
}

}  // namespace

void shift_hubs(std::vector<CrossSection>& rings, const std::vector<double>& arc_lengths,
                const WallTree& wall, double nominal_radius, double size)
{
    std::vector<Vec3> sides;
    for (const CrossSection& ring : rings)
        sides.push_back(open_side(ring, wall, nominal_radius));
    std::vector<Vec3> smooth;
    double largest = least_openness;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        Vec3 sum = Vec3::Zero();
        double weights = 0.0;
        for (std::size_t j = 0; j < rings.size(); ++j) {
            const double u = (arc_lengths[i] - arc_lengths[j]) / (smoothing_ratio * nominal_radius);
            const double weight = std::exp(-0.5 * u * u);
            sum += weight * sides[j];
            weights += weight;
        }
        const Vec3 side = sum / weights;
        smooth.push_back(side - side.dot(rings[i].tangent) * rings[i].tangent);
        largest = std::max(largest, smooth.back().norm());
    }
    for (std::size_t i = 0; i < rings.size(); ++i)
        rings[i].origin += size / largest * smooth[i];
}

}  // namespace braidzone
