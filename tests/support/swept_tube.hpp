#pragma once

#include "core/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace braidzone::test {

/// A piece of a plane axis: an arc that turns by `angle` [rad], to the left if positive, or, if
/// that is 0, a straight piece.
struct AxisPiece {
    double length = 0.0;  ///< [m]
    double angle = 0.0;
};

inline AxisPiece straight(double length)
{
    return {length, 0.0};
}

inline AxisPiece bend(double radius, double angle)
{
    return {radius * std::abs(angle), angle};
}

inline double axis_length(const std::vector<AxisPiece>& pieces)
{
    double length = 0.0;
    for (const AxisPiece& piece : pieces)
        length += piece.length;
    return length;
}

/// Half axes of an elliptical section, in the plane of the tube's axis and across it [m].
struct SectionAxes {
    double in_plane = 0.0;
    double across = 0.0;
};

/// A tube along an axis in the plane z = 0 that begins at the origin along x, open at both ends,
/// normals outwards. The corners of its sections lie on the ellipse.
/// @param edge  target length of the triangles' edges [m]
inline TriangleMesh swept_tube(const std::vector<AxisPiece>& pieces, const SectionAxes& half_axes,
                               double edge)
{
    TriangleMesh mesh;
    const double mean = 0.5 * (half_axes.in_plane + half_axes.across);
    const int around = std::max(12, static_cast<int>(2.0 * std::numbers::pi * mean / edge));
    const auto add_ring = [&](const Vec3& centre, double heading) {
        const Vec3 left(-std::sin(heading), std::cos(heading), 0.0);
        for (int j = 0; j < around; ++j) {
            const double angle = 2.0 * std::numbers::pi * j / around;
            mesh.points.push_back(centre + half_axes.in_plane * std::cos(angle) * left +
                                  half_axes.across * std::sin(angle) * Vec3::UnitZ());
        }
    };
    Vec3 place = Vec3::Zero();
    double heading = 0.0;
    int num_rings = 1;
    add_ring(place, heading);
    for (const AxisPiece& piece : pieces) {
        const int steps = std::max(1, static_cast<int>(std::lround(piece.length / edge)));
        const double turn = piece.angle / steps;
        const double arc = piece.length / steps;
        const double chord = turn == 0.0 ? arc : arc * std::sin(0.5 * turn) / (0.5 * turn);
        for (int k = 0; k < steps; ++k, ++num_rings) {
            const double along = heading + 0.5 * turn;
            place += chord * Vec3(std::cos(along), std::sin(along), 0.0);
            heading += turn;
            add_ring(place, heading);
        }
    }
    for (int k = 0; k + 1 < num_rings; ++k) {
        for (int j = 0; j < around; ++j) {
            const int next = (j + 1) % around;
            const int a = k * around + j, b = k * around + next;
            const int c = (k + 1) * around + next, d = (k + 1) * around + j;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
    return mesh;
}

}  // namespace braidzone::test
