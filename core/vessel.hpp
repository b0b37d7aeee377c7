#pragma once

#include "core/length_unit.hpp"
#include "core/opening.hpp"
#include "core/opening_orders.hpp"
#include "core/surface_labels.hpp"
#include "core/surface_opening.hpp"
#include "core/surface_repair.hpp"
#include "core/triangle_mesh.hpp"

#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// A vessel: its wall, open at the ends, normals out of the lumen.
struct Vessel {
    TriangleMesh wall;               ///< [m]
    std::vector<Opening> openings;   ///< largest area first
    LengthUnit unit;                 ///< that of the file, for output that overlays it
    std::vector<std::string> notes;  ///< what was changed or opened
};

struct VesselOptions {
    Repairs repair = {};         ///< which defects are mended instead of refused
    double cap_angle_deg = 5.0;  ///< a cap's normals are within this of their mean
    /// Where a closed surface without flat caps is cut open; not used for any other surface.
    std::optional<VesselEnds> ends = std::nullopt;
    std::vector<OpeningOrder> orders = {};  ///< openings to keep, cap or cut
    /// Points of given centerlines [m]: a closed surface is cut open where they end, and so is a
    /// rounded end of an open one.
    std::vector<std::vector<Vec3>> lines = {};
};

/// The vessel of a surface: sound, opened at its caps, with its openings measured.
///
/// Corners that nearly coincide are merged (`merged_near_points`), edges split at corners that lie
/// on them (`with_split_edges`), and normals that all point inwards turned; all are noted. Other
/// defects are refused or, where `repair` names them, mended
/// (`repair` in surface_repair.hpp).
///
/// The openings are the rims of an open surface, and the ends whose caps are labelled
/// (`labelled_caps`). A rim without a tube behind it (`lumen_behind`) is a hole: it is refused, or
/// closed by a fan if `repair.holes`. If fewer than two openings are left the surface is opened at
/// its flat caps (`flat_caps`). Then the orders are carried out, and the surface is cut open where
/// the lines end, or else, if it is closed still, at the given ends (`open_rounded_ends`); other
/// rounded ends stay closed.
///
/// @param surface  as `read_labelled_surface` returns it [m]
/// @param unit     the unit of the file
/// @throws GeometryError if the surface is defective (with the list of the defects and the repair
///         that is needed) or has holes (with their place); if it is closed and nothing tells where
///         to open it (with the list of its rounded ends), or cannot be cut open there; if it has
///         fewer than two openings, or is no blood vessel by its size: the largest opening's
///         diameter must lie in 0.5 to 30 mm, which catches a surface whose unit was stated wrongly
Vessel make_vessel(const LabelledSurface& surface, const LengthUnit& unit,
                   const VesselOptions& options = {});
Vessel make_vessel(const TriangleMesh& surface, const LengthUnit& unit,
                   const VesselOptions& options = {});

/// A vessel whose wall has been moved, otherwise the same: its rims were judged before.
/// @param wall  with the same triangles and rims, sound or not
/// @throws GeometryError if the wall has passed itself, so that triangles face the other way, or is
///         defective, with the list of the defects
Vessel with_wall(const Vessel& vessel, TriangleMesh wall);

/// The closed surface of the lumen: the wall with each opening closed by a fan.
struct ClosedLumen {
    TriangleMesh mesh;            ///< the wall's triangles first, then the caps'
    std::vector<int> opening_of;  ///< for each triangle, -1 on the wall or the opening's index
};

ClosedLumen close_openings(const Vessel& vessel);

}  // namespace braidzone
