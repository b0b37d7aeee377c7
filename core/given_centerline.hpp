#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// Which of a file's lines is meant.
struct LineChoice {
    int line = -1;                           ///< its number; -1: see `given_centerline`
    std::optional<int> from = std::nullopt;  ///< opening of its proximal end
    std::optional<int> to = std::nullopt;    ///< and of its distal end
    bool reverse = false;                    ///< the first point is the distal end
};

/// The centerline of a case that comes from a file.
struct GivenCenterline {
    Polyline line;                   ///< proximal end first, in the lumen
    std::vector<std::string> notes;  ///< what was changed
};

/// The centerline out of the lines of a file: the one that is meant, trimmed at the openings
/// (`trimmed_at_openings`), its path in the lumen (`with_path_in_lumen`), its radii filled in.
///
/// Of several lines, as VMTK writes one for each outlet, it is the one with the stated number, or
/// the one that joins the stated openings; without either, the only one, or that which joins the
/// two openings of a vessel that has two. Lines that begin or end at a point of another one, as
/// those of a network do, are joined to the shortest path where no single line will do.
///
/// @param lines  at least one, each in order [m]
/// @throws ConfigError if several lines could be meant or none joins the stated openings, with the
///         list of all; InputError if there is no line of the stated number; GeometryError if the
///         line lies off the vessel (`require_same_frame`),
///         outside the lumen, or passes through the wall
GivenCenterline given_centerline(const std::vector<Polyline>& lines, const Vessel& vessel,
                                 const WallTree& wall, const LineChoice& choice = {});

}  // namespace braidzone
