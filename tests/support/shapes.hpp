#pragma once

#include "core/centerline.hpp"
#include "core/triangle_mesh.hpp"
#include "core/vessel.hpp"

#include <cmath>
#include <numbers>

namespace braidzone::test {

/// A straight tube along z from 0 to `length`, open at both ends, normals outwards. Its wall is a
/// prism of `around` sides whose corners lie on the given radius.
inline TriangleMesh tube(double radius, double length, int around, int along)
{
    TriangleMesh mesh;
    for (int k = 0; k <= along; ++k) {
        for (int j = 0; j < around; ++j) {
            const double angle = 2.0 * std::numbers::pi * j / around;
            mesh.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                     length * k / along);
        }
    }
    for (int k = 0; k < along; ++k) {
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

inline Vessel tube_vessel(double radius, double length, int around = 96, int along = 60)
{
    return make_vessel(tube(radius, length, around, along), LengthUnit{"mm", 1e-3});
}

/// The axis of that tube.
inline Centerline tube_centerline(double radius, double length, double spacing = 0.1e-3)
{
    Polyline line;
    line.points = {Vec3(0, 0, 0), Vec3(0, 0, 0.5 * length), Vec3(0, 0, length)};
    line.inscribed_radii = {radius, radius, radius};
    return resample(line, ResampleOptions{.spacing = spacing, .smoothing = 0.0});
}

/// A closed box of twelve triangles, normals outwards. Point 4 z + 2 y + x is the corner at the
/// upper (1) or lower (0) end of each axis; triangles 0 and 1 are the lower face in z, then the
/// upper one, then the two faces in y and the two in x.
inline TriangleMesh box(const Vec3& lower, const Vec3& upper)
{
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k) {
        mesh.points.emplace_back(k & 1 ? upper.x() : lower.x(), k & 2 ? upper.y() : lower.y(),
                                 k & 4 ? upper.z() : lower.z());
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

}  // namespace braidzone::test
