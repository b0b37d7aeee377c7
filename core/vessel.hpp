#pragma once

#include "core/length_unit.hpp"
#include "core/surface_opening.hpp"
#include "core/triangle_mesh.hpp"

#include <optional>
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
};

/// A vessel: its wall, open at the ends, normals out of the lumen.
struct Vessel {
    TriangleMesh wall;               ///< [m]
    std::vector<Opening> openings;   ///< largest area first
    LengthUnit unit;                 ///< that of the file, for output that overlays it
    std::vector<std::string> notes;  ///< what was repaired or opened on request
};

struct VesselOptions {
    bool repair = false;         ///< mend defects and holes instead of refusing them
    double cap_angle_deg = 5.0;  ///< a cap's normals are within this of their mean
    /// Where a closed surface without flat caps is cut open; not used for any other surface.
    std::optional<VesselEnds> ends = std::nullopt;
};

/// The vessel of a surface: sound, opened at flat caps, with its openings measured.
///
/// An open surface has its rims as openings. A surface with fewer than two rims is opened at its
/// flat caps (`flat_caps`). A closed surface without flat caps, its ends being rounded off, is cut
/// open at the given ends (`open_rounded_ends`); its other ends stay closed. Rims of less than a
/// quarter of the largest opening's radius are holes.
///
/// With `repair`, defects are mended (`repair` in surface_repair.hpp) and holes closed by fans.
///
/// @param surface  as `read_surface` returns it [m]
/// @param unit     the unit of the file
/// @throws GeometryError if the surface is defective or inverted (with the list of the defects) or
///         has holes (with their place), unless `repair`; if it is closed without flat caps and
///         has no ends given or cannot be cut open there; if it has fewer than two openings, or is
///         no blood vessel by its size: the largest opening's diameter must lie in 0.5 to 30 mm,
///         which catches a surface whose unit was stated wrongly
Vessel make_vessel(const TriangleMesh& surface, const LengthUnit& unit,
                   const VesselOptions& options = {});

/// The closed surface of the lumen: the wall with each opening closed by a fan.
struct ClosedLumen {
    TriangleMesh mesh;            ///< the wall's triangles first, then the caps'
    std::vector<int> opening_of;  ///< for each triangle, -1 on the wall or the opening's index
};

ClosedLumen close_openings(const Vessel& vessel);

}  // namespace braidzone
