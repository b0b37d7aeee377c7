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

}  // namespace braidzone::test
