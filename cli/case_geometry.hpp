#pragma once

#include "cli/case_file.hpp"
#include "core/centerline.hpp"
#include "core/given_centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"

namespace braidzone {

/// The vessel of a case: read and, on request, repaired; cut open at the centerline's ends, those
/// of its file or the two points that the case names, if its own are rounded off; its wall moved by
/// `wall_offset`.
/// @throws what `read_surface` and `make_vessel` throw, with the file's name
Vessel read_vessel(const VesselSource& source);

/// The centerline of a case, proximal end first: from its file (`given_centerline`), or computed
/// between the ends that the case names, or between the two openings of a vessel that has two.
/// @throws ConfigError if an end is no opening of the vessel, or no ends are named and the vessel
///         has not two openings; else what `read_centerlines`, `in_evident_order`,
///         `given_centerline` and `compute_centerline` throw
GivenCenterline find_centerline(const VesselSource& source, const Vessel& vessel,
                                const WallTree& wall);

/// Arc length of a place [m].
double arc_length_at(const PlaceOnCenterline& place, const Centerline& centerline);

/// The opening whose centre is nearest to a point: at the centerline's first point, the inlet.
int nearest_opening(const Vessel& vessel, const Vec3& point);

/// "0: diameter 4.20 mm at (1.00, 2.00, 3.00) mm, flat cap", one line for each opening, indented.
std::string describe_openings(const Vessel& vessel);

}  // namespace braidzone
