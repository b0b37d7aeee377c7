#pragma once

#include "core/length_unit.hpp"
#include "core/triangle_mesh.hpp"

#include <string>
#include <utility>
#include <vector>

namespace braidzone {

/// Which defects are mended instead of refused. One does not bring another.
struct Repairs {
    bool normals = false;  ///< turns triangles that wind against their neighbours
    bool merge = false;    ///< drops repeated and flat triangles, splits where three meet
    bool holes = false;    ///< closes holes in the wall
    bool self_intersections = false;  ///< removes triangles that cross, and fills the gaps
    bool parts = false;               ///< keeps the largest of separate parts
    bool operator==(const Repairs&) const = default;
};

inline constexpr Repairs all_repairs{true, true, true, true, true};

/// "normals", "merge", "holes", "self_intersections", "parts".
std::vector<std::string> repair_names();

/// The repairs at some places of `repair_names`.
Repairs repairs_at(const std::vector<std::size_t>& places);

/// The names of the repairs that are asked for.
std::vector<std::string> names_of(const Repairs& repairs);

/// `repair = ["merge", "holes"]`, as a case file states it.
std::string repair_text(const Repairs& repairs);

/// A sound surface from a defective one, by CGAL's Polygon Mesh Processing. Holes stay.
///
/// Normals that all point into the lumen are always turned. Beyond that only what `allowed` names
/// is changed: `merge` makes equal points one, drops repeated and degenerate triangles and splits
/// non-manifold edges and points; `normals` turns triangles that wind against their neighbours;
/// `parts` keeps the largest part, if no other has half of its area; `self_intersections` removes
/// crossing triangles and fills the gaps.
///
/// @param unit  of the places in notes and messages
/// @return the surface, as it is if it is sound, and one sentence for each thing changed
/// @throws GeometryError if a defect's repair is not allowed (with its name), or defects remain
std::pair<TriangleMesh, std::vector<std::string>> repair(const TriangleMesh& mesh,
                                                         const Repairs& allowed,
                                                         const LengthUnit& unit = {});

}  // namespace braidzone
