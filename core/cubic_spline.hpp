#pragma once

#include "core/vector.hpp"

#include <vector>

namespace braidzone {

/// A space curve through given points: a twice continuously differentiable cubic spline over the
/// accumulated chord length, whose first and last pieces are parabolas (fourth-order accurate
/// between the ends; de Boor 1978, A Practical Guide to Splines, chapter IV).
struct CubicSpline {
    std::vector<double> knots;             ///< chord length at each point [m]
    std::vector<Vec3> points;              ///< [m]
    std::vector<Vec3> second_derivatives;  ///< by the parameter [1/m]
    std::vector<double> arc_lengths;       ///< arc length at each point [m]
    double length() const { return arc_lengths.back(); }
};

/// The spline through the points.
/// @param points  two or more, no two neighbours equal
CubicSpline fit_spline(const std::vector<Vec3>& points);

/// A place on a spline: in piece `piece`, at the fraction of its parameter interval.
struct SplinePlace {
    int piece = 0;
    double fraction = 0.0;
};

/// The place at an arc length, which is clamped to the curve [m].
SplinePlace place_at(const CubicSpline& spline, double arc_length);

/// The point there [m].
Vec3 point_at(const CubicSpline& spline, const SplinePlace& place);

/// Derivative by the parameter there: along the tangent, of about unit length.
Vec3 derivative_at(const CubicSpline& spline, const SplinePlace& place);

}  // namespace braidzone
