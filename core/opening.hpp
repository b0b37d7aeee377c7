#pragma once

#include "core/triangle_mesh.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// An open end of the vessel.
struct Opening {
    Vec3 centre = Vec3::Zero();   ///< area centroid of the rim's polygon [m]
    Vec3 normal = Vec3::UnitX();  ///< unit, out of the lumen
    double area = 0.0;            ///< of the rim's polygon, seen along the normal [m^2]
    double radius = 0.0;          ///< sqrt(area / pi) [m]
    std::vector<int> rim;         ///< points of the wall, anticlockwise as seen from outside
    std::string kind = "rim";     ///< how it came to be open: "rim", "flat cap", "cut", ...
};

/// Measures an opening on its rim's polygon, seen along the rim's vector area, so that the figures
/// do not depend on how the rim would be filled.
/// @param rim  a loop of `border_loops`
Opening measured_opening(const TriangleMesh& wall, std::vector<int> rim);

/// All rims of an open surface, largest area first.
std::vector<Opening> measured_openings(const TriangleMesh& wall);

}  // namespace braidzone
