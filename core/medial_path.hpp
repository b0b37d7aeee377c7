#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

/// The centerline by VMTK's definition, beside a path in the middle of the vessel: it minimises
///
///     integral ds / R,    R the radius of the largest sphere in the lumen around the point
///
/// (Antiga, Ene-Iordache and Remuzzi 2003, doi 10.1109/TMI.2003.812261, on the Voronoi diagram,
/// where the minimum lies). In a round vessel that is its axis. In an oval one the minimum moves to
/// the inner side of a bend: where the larger half axis a of an ellipse lies in the bend's plane,
/// by
///
///     x = min(c^2 / R_b, c^2 / a),    c^2 = a^2 - b^2,
///
/// b the smaller half axis and R_b the bend radius of the ellipse's centre, since
/// R^2 = b^2 (1 - x^2 / c^2) on the major axis up to x = c^2 / a.
///
/// R is measured in cross-sections of the given path, on their contour by 64 rays; the points move
/// in the sections' planes, by dynamic programming over 25 places a section, drawn together round
/// by round to a hundredth of the radius. In sections that open into a sac or a branch (a ray of
/// more than twice the vessel's radius, and 1.3 times the median at its angle over four radii to
/// either side), and within one radius of them, the points stay on the given path, so that the
/// larger spheres there do not draw it in; so do the two ends. Where a sac is shallower than the
/// vessel's radius, it counts as part of the vessel.
///
/// @param middle  as `centred_path` returns it, |N| x 3 points [m] and radii
/// @return smooth path with the distance to the wall as radii and the same ends
Polyline medial_path(const Polyline& middle, const WallTree& wall);

}  // namespace braidzone
