#pragma once

#include "core/vector.hpp"

#include <vector>

namespace braidzone {

/// A polyline along the vessel as it was read or computed: |N| x 3 points [m], proximal end first,
/// and, if known, the radius of the largest inscribed sphere at each [m].
struct Polyline {
    std::vector<Vec3> points;
    std::vector<double> inscribed_radii;  ///< |N|, or empty
};

/// Frame of a cross-section: origin on the centerline, orthonormal axes.
struct CrossSection {
    Vec3 origin = Vec3::Zero();
    Vec3 tangent = Vec3::UnitX();   ///< downstream: towards the distal end
    Vec3 normal = Vec3::UnitY();    ///< rotation-minimising: does not turn about the tangent
    Vec3 binormal = Vec3::UnitZ();  ///< tangent x normal
    double inscribed_radius = 0.0;  ///< [m]
};

/// A centerline resampled at uniform arc length, with rotation-minimising frames.
///
/// Arc length is 0 at the proximal end (the inlet) and grows downstream.
struct Centerline {
    std::vector<CrossSection> sections;  ///< |N|, N >= 2
    double spacing = 0.0;                ///< arc length between sections [m]
    double length() const { return spacing * static_cast<double>(sections.size() - 1); }
};

struct ResampleOptions {
    double spacing = 0.1e-3;  ///< wanted; the nearest that divides the length is used [m]
    /// Standard deviation of the Gaussian that smooths the points, over the mean inscribed radius.
    /// It removes the voxel and Voronoi noise that would tilt the cross-sections; end points stay.
    double smoothing = 0.5;
};

/// Resamples a polyline at uniform arc length, smooths it, and carries a frame along it by double
/// reflection (Wang, Juettler, Zheng and Liu 2008, ACM Trans. Graph. 27:2, doi
/// 10.1145/1330511.1330513), which is fourth-order accurate in the spacing.
///
/// Between its points the polyline is a twice continuously differentiable cubic spline, so that
/// coarse polylines have smooth tangents too. Smoothing replaces each point by the value there of
/// a quadratic in arc length, fitted to its neighbours with Gaussian weights: unlike a plain
/// Gaussian mean, which pulls a bend of radius R inwards by (sigma / R)^2 / 2, it moves the bend by
/// only (sigma / R)^4 / 8 of R, and it does not shorten or straighten the ends.
///
/// @param polyline  at least two distinct points, with radii; points closer to their predecessor
///                  than a hundredth of the spacing count as repeated and are skipped
/// @throws InputError if there are fewer than two distinct points, a value is not finite, or radii
///         are missing or not positive, or if an option is out of range
Centerline resample(const Polyline& polyline, const ResampleOptions& options = {});

/// The cross-section at an arc length, interpolated between the two nearest sections (the origin
/// cubically, continuous with its derivative); the tangent and the normal are orthonormal again.
/// @param arc_length  [m], 0 to `centerline.length()`
/// @throws InputError outside that range
CrossSection section_at(const Centerline& centerline, double arc_length);

/// Arc length of the centerline's point nearest to `point` [m].
double nearest_arc_length(const Centerline& centerline, const Vec3& point);

}  // namespace braidzone
