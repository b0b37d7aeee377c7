#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "support/shapes.hpp"

#include <cmath>

namespace braidzone::test {

/// A tube along an arc of a circle about the z axis, from (bend radius, 0, 0) towards y, open at
/// both ends.
struct BentTube {
    double radius = 1.8e-3;       ///< of the tube [m]
    double bend_radius = 3.6e-3;  ///< of its axis [m]
    double angle = 3.0;           ///< [rad]

    double length() const { return bend_radius * angle; }

    /// Place and frame on the axis, at an angle; the frame's normal points away from the z axis.
    CrossSection section(double at) const
    {
        CrossSection section;
        section.normal = Vec3(std::cos(at), std::sin(at), 0.0);
        section.origin = bend_radius * section.normal;
        section.tangent = Vec3(-std::sin(at), std::cos(at), 0.0);
        section.binormal = section.tangent.cross(section.normal);
        section.inscribed_radius = radius;
        return section;
    }

    Vessel vessel(int around = 96, int along = 200) const
    {
        TriangleMesh mesh = tube(radius, 1.0, around, along);
        for (Vec3& point : mesh.points) {
            const CrossSection here = section(angle * point.z());
            point = here.origin + point.x() * here.normal + point.y() * here.binormal;
        }
        return make_vessel(std::move(mesh), LengthUnit{"mm", 1e-3});
    }

    Centerline centerline() const
    {
        Polyline line;
        const int count = 200;
        for (int i = 0; i <= count; ++i) {
            line.points.push_back(section(angle * i / count).origin);
            line.inscribed_radii.push_back(radius);
        }
        return resample(line, ResampleOptions{.spacing = 0.1e-3, .smoothing = 0.0});
    }
};

}  // namespace braidzone::test
