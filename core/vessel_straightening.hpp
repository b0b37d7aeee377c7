#pragma once

#include "core/centerline.hpp"
#include "core/triangle_mesh.hpp"

namespace braidzone {

/// A stiff device takes curvature out of the vessel that it lies in.
///
/// With s the arc length of the centerline and k1, k2 the components of its curvature along the
/// normal and binormal of the rotation-minimising frame (Bishop 1975, doi 10.2307/2319846),
///
///     (k1, k2)'(s) = (1 - share w(s)) (k1, k2)(s),   w(s) = S(2 (1 - |s - centre| / half_width))
///
/// S being `smooth_step`: w is 1 in the middle half of the window and fades over the quarters at
/// its ends, as the device's stiffness does at its ends. Lengths along the centerline and the
/// cross-sections stay: the vessel bends, it is neither stretched nor flattened. A vessel beyond
/// the window is carried along as it is.
///
/// Where the vessel as a whole comes to lie is not a matter of its shape. The one rigid motion that
/// is free is that which brings the cross-sections of the kept stretch closest to where they were,
/// in the least squares of their points: a scan of the device is registered on the vessel around
/// it. Without a kept stretch it is the window, weighted by w.
struct VesselStraightening {
    double share = 0.0;       ///< of the curvature that is taken out [-]; 0 (none) to 1 (straight)
    double centre = 0.0;      ///< of the window, arc length on the centerline [m]
    double half_width = 0.0;  ///< of the window [m]; > 0 if share > 0
    double kept_from = 0.0;   ///< kept stretch, arc length [m]
    double kept_to = 0.0;     ///< [m]; not beyond kept_from: the window is kept
};

/// @throws ConfigError if the share is not in 0 to 1, the window has no width, or a place is not
///         finite
void validate(const VesselStraightening& straightening);

/// A wall and its centerline.
struct WallWithCenterline {
    TriangleMesh wall;
    Centerline centerline;
};

/// The vessel with its centerline straightened and its wall carried along: a point p at the place s
/// of its foot on the centerline keeps its coordinates in the frame F there,
///
///     p' = c'(s) + F'(s) F(s)^T (p - c(s)),   the foot being where F_tangent (p - c(s)) = 0
///
/// Points beyond the centerline's ends move with the ends. The turn of the frame between two
/// sections is scaled as a rotation vector, and the step between them turns with it as along an arc
/// of a circle: arcs become arcs and straight lines exactly.
///
/// Covers tubes, bends and sacs on them. A sac on the outer side of a bend becomes shorter along
/// the vessel, by the curvature taken out times its distance from the centerline.
///
/// @throws ConfigError as `validate`; GeometryError if the kept stretch is off the centerline, or
/// the
///         wall folds or is drawn out or in to a quarter or four times an edge's length: on the
///         inner side of a bend, or where a branch comes close to another part of the centerline
WallWithCenterline straightened(const TriangleMesh& wall, const Centerline& centerline,
                                const VesselStraightening& straightening);

}  // namespace braidzone
