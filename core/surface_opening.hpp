#pragma once

#include "core/triangle_mesh.hpp"

#include <optional>
#include <vector>

namespace braidzone {

/// The two ends of the part of a vessel that is of interest.
struct VesselEnds {
    Vec3 from = Vec3::Zero();  ///< proximal [m]
    Vec3 to = Vec3::Zero();    ///< distal [m]
};

/// Where a lumen is to be cut across.
struct LumenEnd {
    Vec3 point = Vec3::Zero();      ///< in the lumen [m]
    Vec3 outwards = Vec3::UnitX();  ///< unit, along the lumen, towards what is taken off
    double radius = 0.0;            ///< of the largest sphere in the lumen beside the end [m]
};

/// Cuts a vessel across (`cut_across`) at some ends and takes off what lies beyond.
///
/// A cut is plausible if its section is at most twice as wide as the largest sphere that fits into
/// the lumen beside it, and if the piece taken off stays within five of that sphere's radii from
/// the point and has at most a quarter of the surface's area.
///
/// @param surface  sound; closed, or with rims that the cuts do not meet
/// @throws GeometryError if a cut is not plausible, or the surface is not sound after it
TriangleMesh cut_open(const TriangleMesh& surface, const std::vector<LumenEnd>& ends);

class WallTree;

/// Where the lumen is to be cut so that a line ends there: at the line's last point, or, if that
/// lies in the round of a tip or beyond the wall, as far back as the lumen reaches 0.8 of its
/// radius. The radius is the first largest distance to the wall on the way back along the line;
/// the direction is that of the chord over one radius.
/// @param line  its last point is the end [m]
/// @return none if the line does not run through the lumen
std::optional<LumenEnd> end_of_line(const std::vector<Vec3>& line, const WallTree& wall);

/// Opens a closed vessel whose ends are rounded off, as segmentation often leaves them: cuts it
/// across at two points and takes off the tips.
///
/// The cut goes through the point, across the local direction of the lumen: the tangent of the
/// centred least-cost path (`least_cost_path`, `centred_path`) between the centres of the sections
/// at the two points. The tangent is taken one and two radii inwards and extrapolated linearly, as
/// rounded ends have no axis of their own. Radius there is the vessel's mean, 2 V / A, which is
/// exact for a tube; V is the enclosed volume, A the area. Other parts of the vessel that the plane
/// meets stay whole (`cut_across`). Side branches stay closed: they are dead ends.
///
/// The cuts must be plausible (`cut_open`).
///
/// @param surface  sound and closed
/// @param ends     in the lumen, near the tips: within a radius or two of them, say
/// @return the surface with a plane rim at each end
/// @throws GeometryError if a point is not in the lumen, the two are at one place, no path joins
///         them, a cut is not plausible, or the surface is not sound after it
TriangleMesh open_rounded_ends(const TriangleMesh& surface, const VesselEnds& ends);

}  // namespace braidzone
