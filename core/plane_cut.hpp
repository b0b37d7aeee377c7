#pragma once

#include "core/triangle_mesh.hpp"

namespace braidzone {

/// A tube-like surface in two parts.
struct PlaneCut {
    TriangleMesh kept;                   ///< the part behind the plane, with a plane rim
    TriangleMesh removed;                ///< the part beyond
    double section_area = 0.0;           ///< of the section between them [m^2]
    Vec3 section_centre = Vec3::Zero();  ///< its area centroid [m]
};

/// Cuts a surface across, along its plane section around a point.
///
/// Only the closed section that encloses the point is cut, the innermost one if there are several:
/// where the plane meets other parts of the surface they stay whole, on the side that they are
/// connected to. Triangles are split at the plane; points nearer to it than a tenth of their
/// shortest edge are moved onto it instead, so that no slivers arise.
///
/// @param mesh    manifold, normals outwards, closed or with rims that the section does not meet
/// @param point   within the surface [m]
/// @param normal  unit normal of the plane, towards the part to be removed
/// @throws GeometryError if no closed section encloses the point, if it is smaller than the
///         triangles there, or if the surface is still in one part when it is cut there, as a ring
///         is
PlaneCut cut_across(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal);

}  // namespace braidzone
