#pragma once

#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

enum class DeviceEnd { distal, proximal };

/// An end of the device that has not opened in full: a tail that hangs on to the delivery wire or
/// is held by friction of its own wires (tail malapposition in 25 % of flow diverters, Jilin 2023).
///
/// The rings of the last `length` open only as far as a cone allows, in place of the wall: the stop
/// of a node (`wall_contact.hpp`) at the angle a of its ring, at the distance d from the end, is
///
///     stop' = (1 - shrink w S(1 - d / length)) min(stop, R0 sqrt(1 + t^2)),   S: `smooth_step`
///     w = 1 - lean cos(a - lean_angle)
///
/// A ring that the wall would hold keeps its shape and is narrower by that share; one in the open,
/// where R0 sqrt(1 + t^2) is as far as any ring opens, is held as well. The cone is continuous with
/// its slope in place, length and shrink. A tail that leans lies nearer to the wall on one side, on
/// it at 1: to first order a cone whose middle is moved aside by lean times the gap. What holds a
/// tail back is not modelled, only that it is held; the cone bears the radial force there, and the
/// wall none where the gap exceeds a wire's radius. With a compliant wall the cone is as soft as
/// the wall.
struct IncompleteOpening {
    DeviceEnd end = DeviceEnd::proximal;
    double length = 0.0;  ///< along the centerline, from the device's end [m]; > 0
    double shrink = 0.0;  ///< of the radius at the very end, on average around [-]; 0 to 0.8
    double lean = 0.0;    ///< 0 to 1 [-]
    /// Direction in which it leans, about the downstream axis from the ring frame's normal [rad].
    double lean_angle = 0.0;
};

/// @throws ConfigError if a length, a shrink or a lean is out of range, or an end is given twice
void validate(const std::vector<IncompleteOpening>& openings);

/// The stops with the cones.
/// @param stops        |N| of the wall [m]
/// @param arc_lengths  of the rings on the centerline, decreasing [m]
/// @param braid_ratio  t [-]
/// @param smallest     radius of the catheter, to which no stop falls [m]
std::vector<double> narrowed_stops(const std::vector<IncompleteOpening>& openings,
                                   const std::vector<double>& stops, const BraidLattice& lattice,
                                   const std::vector<double>& arc_lengths, double braid_ratio,
                                   double smallest);

}  // namespace braidzone
