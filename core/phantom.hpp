#pragma once

#include "core/centerline.hpp"
#include "core/triangle_mesh.hpp"

#include <optional>
#include <vector>

namespace braidzone {

/// One piece of a parent vessel: an arc of a circle, or a straight piece if the angle is 0.
struct PhantomSegment {
    double length = 0.0;  ///< along the axis [m]; > 0
    double angle = 0.0;   ///< by which the axis turns [rad]; 0 to 2 pi
    /// Direction of the turn about the axis, from the rotation-minimising frame's normal [rad]:
    /// 0 and then pi make an S-bend, 0 and then pi / 2 a bend that leaves the first one's plane.
    double plane_angle = 0.0;
};

/// A sac: a sphere or ellipsoid that meets the parent vessel in a neck.
///
/// The neck's diameter is measured along the parent vessel, where sac and wall meet before the
/// fillet between them, which widens it by less than twice the blend radius, or up to four times
/// where the sac overhangs its neck far.
struct PhantomSac {
    /// Arc length of the neck's centre [m]; none: at the apex of the bifurcation, where the sac
    /// continues the parent's axis and the neck is measured across both daughters.
    std::optional<double> position;
    double direction = 0.0;  ///< about the axis, from the frame's normal [rad]; not at an apex
    double diameter = 0.0;   ///< across, parallel to the parent vessel [m]
    double height = 0.0;     ///< along the outward direction [m]; equal to `diameter` for a sphere
    double neck = 0.0;       ///< diameter of the neck [m]; < diameter
    double edge_length = 0.0;  ///< of the triangles on the dome [m]; 0: as everywhere
};

/// A side branch: a straight tube that leaves the parent vessel.
struct PhantomBranch {
    double position = 0.0;             ///< arc length of its origin on the parent's axis [m]
    double direction = 0.0;            ///< about the axis, from the frame's normal [rad]
    double tilt = 1.0471975511965976;  ///< between the branch and the downstream axis [rad]
    double radius = 0.0;               ///< at most the parent's there [m]
    double length = 0.0;               ///< from the parent's axis [m]
};

/// A terminal bifurcation: two straight daughters at the distal end of the parent vessel, the first
/// towards the frame's normal, the second away from it.
struct PhantomBifurcation {
    double radius = 0.0;  ///< of the daughters [m]; at most the parent's distal radius
    double length = 0.0;  ///< from the end of the parent's axis [m]
    double half_angle = 0.7853981633974483;  ///< between a daughter and the parent's axis [rad]
};

/// Parameters of an idealised vessel.
struct Phantom {
    std::vector<PhantomSegment> segments;  ///< the parent vessel, proximal end first
    double proximal_radius = 2e-3;         ///< [m]
    double distal_radius = 2e-3;           ///< [m]; linear taper between the two
    /// Smaller over larger half axis of the parent vessel's section, an ellipse with the area of
    /// the circle of the radii above; 0.5 to 1, 1: round.
    double ovality = 1.0;
    double oval_direction = 0.0;  ///< of the larger half axis, from the frame's normal [rad]
    std::vector<PhantomSac> sacs;
    std::vector<PhantomBranch> branches;
    std::optional<PhantomBifurcation> bifurcation;
    double blend_radius = 0.3e-3;  ///< of the fillet where parts meet at right angles [m]
    double edge_length = 0.4e-3;   ///< target edge of the triangles [m]
};

/// An idealised vessel: its wall, open at the ends, and its exact centerline with radii.
struct PhantomVessel {
    TriangleMesh wall;  ///< [m], normals out of the lumen
    /// The parent's axis; at a bifurcation on through the first daughter, with the corner between
    /// the axes rounded to a bend of three times the daughter's radius.
    Polyline centerline;
};

/// Makes an idealised vessel: the zero level of a smooth union of tubes and ellipsoids, meshed with
/// nearly equilateral triangles whose points lie on that level, cut square at the ends.
///
/// An oval section keeps its direction in the rotation-minimising frame; the centerline's radii are
/// then its smaller half axes, those of the inscribed spheres.
///
/// @throws ConfigError if a parameter is out of range (a neck wider than its sac, a bend tighter
///         than the radius, a part that does not touch the parent vessel)
PhantomVessel make_phantom(const Phantom& phantom);

}  // namespace braidzone
