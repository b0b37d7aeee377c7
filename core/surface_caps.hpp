#pragma once

#include "core/triangle_mesh.hpp"

#include <vector>

namespace braidzone {

/// The flat caps over the ends of a vessel, each as a list of its triangles.
///
/// A cap is a connected region that meets the wall at edges sharper than 45 degrees, is flat, has
/// one rim, and is as round as a cross-section: its isoperimetric quotient 4 pi A / P^2 (1 for a
/// circle, 0.79 for a square, 0.69 for an ellipse of aspect 3) is at least 0.5. The lumen behind it
/// is about as wide: with r = sqrt(A / pi), the surface comes nearer than 1.5 r to the point 2 r
/// behind the cap's middle. (Behind a facet of a rough wall nothing is nearer than the facet.) A
/// cap whose area is below 1/100 of the largest one's is a facet of the wall, too.
///
/// @param mesh       sound
/// @param angle_deg  a cap's normals differ from their mean by less than this
std::vector<std::vector<int>> flat_caps(const TriangleMesh& mesh, double angle_deg);

}  // namespace braidzone
