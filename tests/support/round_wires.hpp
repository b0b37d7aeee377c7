#pragma once

#include "support/periodic_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace braidzone::test {

/// An endless straight wire of circular cross-section.
struct RoundWire {
    Vec3 point = Vec3::Zero();       ///< of the axis
    Vec3 direction = Vec3::UnitX();  ///< unit
    double radius = 0.0;

    /// The part of `offset` across the wire.
    Vec3 across(const Vec3& offset) const { return offset - direction.dot(offset) * direction; }

    double distance(const Vec3& x) const { return across(x - point).norm() - radius; }
};

/// Wires and their images in the boxes around; those far enough for every link of the box.
inline std::vector<RoundWire> with_images(const std::vector<RoundWire>& wires,
                                          const PeriodicBox& box)
{
    std::vector<RoundWire> all;
    for (const RoundWire& wire : wires) {
        for (int k = -1; k <= 1; ++k) {
            for (int j = -2; j <= 2; ++j) {
                for (int i = -2; i <= 2; ++i) {
                    RoundWire image = wire;
                    image.point += box.image(i, j, k);
                    const bool known =
                        std::any_of(all.begin(), all.end(), [&](const RoundWire& other) {
                            return other.direction == image.direction &&
                                   other.across(image.point - other.point).norm() <
                                       1e-9 * box.dims[0];
                        });
                    if (!known) all.push_back(image);
                }
            }
        }
    }
    return all;
}

/// Part of the link from x to x + c that lies outside a wire, 0 ... 1; infinite if the link does
/// not meet it. Solves |across(x - point) + t across(c)| = radius for the smaller t.
inline double free_part(const RoundWire& wire, const Vec3& x, const Vec3& c)
{
    const Vec3 start = wire.across(x - wire.point), step = wire.across(c);
    const double a = step.squaredNorm(), b = start.dot(step);
    const double gap = start.squaredNorm() - wire.radius * wire.radius;
    const double discriminant = b * b - a * gap;
    constexpr double none = std::numeric_limits<double>::infinity();
    if (!(a > 0.0 && b < 0.0 && discriminant >= 0.0)) return none;
    const double t = gap / (-b + std::sqrt(discriminant));
    return t <= 1.0 ? std::max(t, 0.0) : none;
}

}  // namespace braidzone::test
