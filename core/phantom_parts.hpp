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

/// The parent vessel about its axis, with straight overhangs and round ends beyond them [m].
PhantomPart parent_tube(const Phantom& phantom, const PhantomAxis& axis, double proximal_overhang,
                        double distal_overhang);

/// A tube with round ends about the line between two points.
PhantomPart straight_tube(const std::string& name, const Vec3& from, const Vec3& to, double radius);

/// An ellipsoid of revolution about `outwards`. Its level has unit gradient on the wall:
///
///     f = k0 (k0 - 1) / k1,  k0 = |p / a|, k1 = |p / a^2|, a the half axes;
///
/// for a sphere this is the distance.
PhantomPart ellipsoid(const std::string& name, const PhantomSac& sac, const Vec3& centre,
                      const Vec3& outwards);

/// The level of the union of two parts that meet in a fillet, a circle of the given radius r where
/// they meet at right angles:
///
///     f = max(r, min(a, b)) - |(max(r - a, 0), max(r - b, 0))|.
double smooth_minimum(double a, double b, double radius);

}  // namespace braidzone
