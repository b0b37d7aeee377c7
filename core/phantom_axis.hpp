#pragma once

#include "core/centerline.hpp"
#include "core/phantom.hpp"

#include <vector>

namespace braidzone {

/// One piece of a phantom's axis: an arc of a circle or, if the curvature is 0, a straight line.
struct AxisPiece {
    CrossSection start;            ///< where it begins; its radius is not used
    Vec3 towards = Vec3::UnitY();  ///< from the start to the centre of the arc, unit
    double curvature = 0.0;        ///< 1 / radius of the bend [1/m]
    double arc_length = 0.0;       ///< at the start [m]
    double length = 0.0;           ///< [m]
};

/// The axis of a phantom's parent vessel, tangent-continuous. It begins at the origin along x with
/// the frame's normal along y; arc length is 0 there.
struct PhantomAxis {
    std::vector<AxisPiece> pieces;
    double length = 0.0;  ///< [m]
};

/// The axis made of the segments one after another. The bend of a segment is towards
/// `cos(plane_angle) normal + sin(plane_angle) binormal` of the rotation-minimising frame.
PhantomAxis make_axis(const std::vector<PhantomSegment>& segments);

/// The axis with a straight piece added at its proximal end and one at its distal end [m]; arc
/// length stays 0 at the old proximal end.
PhantomAxis with_straight_ends(const PhantomAxis& axis, double proximal, double distal);

/// Point and rotation-minimising frame of a piece at a distance along it [m].
CrossSection section_along(const AxisPiece& piece, double distance);

/// Point and rotation-minimising frame at an arc length, clamped to the axis [m].
CrossSection section_along(const PhantomAxis& axis, double arc_length);

/// Distance along the piece of its point nearest to `point` [m].
double nearest_along(const AxisPiece& piece, const Vec3& point);

}  // namespace braidzone
