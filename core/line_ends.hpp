#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

/// One end of a line.
struct LineEnd {
    int opening = -1;      ///< of the vessel, at which the line ends; -1: within the lumen
    double trimmed = 0.0;  ///< length that was taken off [m]
};

/// A line that ends at the vessel's openings, or within the lumen.
struct TrimmedLine {
    Polyline line;
    LineEnd first, last;
};

/// Takes off what of a line lies beyond the openings. VMTK's lines reach past them, as do lines of
/// a vessel that was cut shorter, or open, afterwards.
///
/// The line then ends where it passes through the opening's cap; an end that is beyond it by less
/// than a hundredth of the distance to the wall is left. An end belongs to the opening it was
/// trimmed at, or else to the nearest one if its middle is within three of its radii.
///
/// @param line  two points or more, in order [m]
/// @throws GeometryError if a point lies outside the lumen elsewhere: between others that are
///         within, or beyond the wall; or if no point lies in the lumen
TrimmedLine trimmed_at_openings(const Polyline& line, const Vessel& vessel, const WallTree& wall);

}  // namespace braidzone
