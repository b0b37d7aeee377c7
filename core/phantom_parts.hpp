#pragma once

#include "core/phantom.hpp"
#include "core/phantom_axis.hpp"

#include <functional>
#include <string>

namespace braidzone {

/// One part of a phantom's lumen: about the signed distance to its wall, negative inside [m].
struct PhantomPart {
    std::string name;  ///< for messages, e.g. "sac 1"
    std::function<double(const Vec3&)> level;
    Box bounds;  ///< holds the part
};

/// Length of the parent vessel's axis [m].
double axis_length(const Phantom& phantom);

/// Radius of the parent vessel at an arc length, clamped to its ends [m].
double parent_radius(const Phantom& phantom, double arc_length);

/// Half axes of an elliptic section [m].
struct HalfAxes {
    double larger = 0.0;
    double smaller = 0.0;
};

/// Half axes of the parent vessel's section at an arc length, r / sqrt(ovality) and
/// r sqrt(ovality): the area is that of the circle of radius r.
HalfAxes parent_half_axes(const Phantom& phantom, double arc_length);

/// The parent vessel about its axis, with straight overhangs and round ends beyond them [m].
PhantomPart parent_tube(const Phantom& phantom, const PhantomAxis& axis, double proximal_overhang,
                        double distal_overhang);

/// A tube with round ends about the line between two points.
PhantomPart straight_tube(const std::string& name, const Vec3& from, const Vec3& to, double radius);

/// Level of an ellipsoid with its axes along the coordinates, of unit gradient on its surface:
///
///     f = k0 (k0 - 1) / k1,  k0 = |p / a|, k1 = |p / a^2|, a the half axes;
///
/// for a sphere this is the distance [m].
double ellipsoid_level(const Vec3& point, const Vec3& half_axes);

/// An ellipsoid of revolution about `outwards`.
PhantomPart ellipsoid(const std::string& name, const PhantomSac& sac, const Vec3& centre,
                      const Vec3& outwards);

/// The level of the union of two parts that meet in a fillet, a circle of the given radius r where
/// they meet at right angles:
///
///     f = max(r, min(a, b)) - |(max(r - a, 0), max(r - b, 0))|.
double smooth_minimum(double a, double b, double radius);

}  // namespace braidzone
