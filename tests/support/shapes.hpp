#pragma once

#include "core/centerline.hpp"
#include "core/triangle_mesh.hpp"
#include "core/vessel.hpp"

#include <cmath>
#include <numbers>
#include <vector>

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

/// A cross-section of a tube: e1 x e2 is along the tube's axis.
struct Ring {
    Vec3 centre, e1, e2;
    double radius = 0.0;
};

/// A closed surface through rings, normals outwards. The first and the last ring are points.
inline TriangleMesh closed_rings(const std::vector<Ring>& rings, int around)
{
    TriangleMesh mesh;
    const int last = static_cast<int>(rings.size()) - 1;
    mesh.points.push_back(rings.front().centre);
    for (int k = 1; k < last; ++k) {
        const Ring& ring = rings[static_cast<std::size_t>(k)];
        for (int j = 0; j < around; ++j) {
            const double angle = 2.0 * std::numbers::pi * j / around;
            mesh.points.push_back(ring.centre + ring.radius * (std::cos(angle) * ring.e1 +
                                                               std::sin(angle) * ring.e2));
        }
    }
    mesh.points.push_back(rings.back().centre);
    const int apex = static_cast<int>(mesh.points.size()) - 1;
    const auto point = [&](int k, int j) { return 1 + (k - 1) * around + j % around; };
    for (int j = 0; j < around; ++j) {
        mesh.triangles.push_back({0, point(1, j + 1), point(1, j)});
        for (int k = 1; k + 1 < last; ++k) {
            mesh.triangles.push_back({point(k, j), point(k, j + 1), point(k + 1, j + 1)});
            mesh.triangles.push_back({point(k, j), point(k + 1, j + 1), point(k + 1, j)});
        }
        mesh.triangles.push_back({apex, point(last - 1, j), point(last - 1, j + 1)});
    }
    return mesh;
}

/// A bent tube with hemispherical ends: `frame(s)` is the axis' frame at arc length s, for s from
/// -radius to `length` + radius, the cylinder being between 0 and `length`.
template <typename Frame>
TriangleMesh rounded_tube(double radius, double length, int around, int along, Frame frame)
{
    std::vector<Ring> rings;
    const int polar = around / 4;
    const auto add = [&](double arc_length, double ring_radius) {
        Ring ring = frame(arc_length);
        ring.radius = ring_radius;
        rings.push_back(ring);
    };
    for (int k = 0; k < polar; ++k) {
        const double angle = 0.5 * std::numbers::pi * k / polar;  // from the tip
        add(-radius * std::cos(angle), radius * std::sin(angle));
    }
    for (int k = 0; k <= along; ++k)
        add(length * k / along, radius);
    for (int k = polar - 1; k >= 0; --k) {
        const double angle = 0.5 * std::numbers::pi * k / polar;
        add(length + radius * std::cos(angle), radius * std::sin(angle));
    }
    return closed_rings(rings, around);
}

/// A cylinder along z from 0 to `length` with hemispherical ends.
inline TriangleMesh capsule(double radius, double length, int around, int along)
{
    return rounded_tube(radius, length, around, along, [](double z) {
        return Ring{Vec3(0, 0, z), Vec3::UnitX(), Vec3::UnitY()};
    });
}

/// The box from (0, 0, 0) to (1, 1, 1).
inline TriangleMesh unit_box()
{
    return box(Vec3::Zero(), Vec3::Ones());
}

/// Two meshes as one; nothing is merged.
inline TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other)
{
    const int offset = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (const auto& [a, b, c] : other.triangles) {
        mesh.triangles.push_back({a + offset, b + offset, c + offset});
    }
    return mesh;
}

}  // namespace braidzone::test
