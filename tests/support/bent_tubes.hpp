#pragma once

#include "support/shapes.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace braidzone::test {

/// An open tube through rings, normals outwards.
inline TriangleMesh open_rings(const std::vector<Ring>& rings, int around)
{
    TriangleMesh mesh;
    for (const Ring& ring : rings) {
        for (int j = 0; j < around; ++j) {
            const double angle = 2.0 * std::numbers::pi * j / around;
            mesh.points.push_back(ring.centre + ring.radius * (std::cos(angle) * ring.e1 +
                                                               std::sin(angle) * ring.e2));
        }
    }
    for (int k = 0; k + 1 < static_cast<int>(rings.size()); ++k) {
        for (int j = 0; j < around; ++j) {
            const int a = k * around + j, b = k * around + (j + 1) % around;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
        }
    }
    return mesh;
}

/// A U in the plane y = 0: a leg up along z at x = 0, a half circle about (bend, 0, leg), a leg
/// down at x = 2 bend.
struct UTube {
    double radius = 0.0;
    double bend = 0.0;  ///< radius of the axis; > radius
    double leg = 0.0;

    double length() const { return 2.0 * leg + std::numbers::pi * bend; }

    /// Point of the axis at an arc length, and the section's axis in the plane of the U.
    Ring section(double arc_length) const
    {
        const double turn = std::clamp((arc_length - leg) / bend, 0.0, std::numbers::pi);
        const Vec3 inwards(std::cos(turn), 0.0, -std::sin(turn));
        const Vec3 along(std::sin(turn), 0.0, std::cos(turn));
        const double straight = arc_length < leg
                                    ? arc_length - leg
                                    : std::max(0.0, arc_length - leg - std::numbers::pi * bend);
        const Vec3 centre = Vec3(bend, 0.0, leg) - bend * inwards + straight * along;
        return {centre, inwards, along.cross(inwards), radius};
    }

    Vec3 axis(double arc_length) const { return section(arc_length).centre; }

    TriangleMesh wall(int around = 48, double step = 0.4e-3) const
    {
        std::vector<Ring> rings;
        const int num = static_cast<int>(std::ceil(length() / step));
        for (int k = 0; k <= num; ++k)
            rings.push_back(section(length() * k / num));
        return open_rings(rings, around);
    }

    Vessel vessel() const { return make_vessel(wall(), LengthUnit{"mm", 1e-3}); }
};

}  // namespace braidzone::test
