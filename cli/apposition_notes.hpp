#pragma once

#include "core/length_unit.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"
#include "deploy/neck.hpp"
#include "deploy/release_schedule.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// A device as it lies in the vessel, and how it got there.
struct PlacedDevice {
    const FlowDiverter& device;
    const ReleaseSchedule& schedule;
    const Deployment& deployment;
    const std::vector<WallOpening>& openings;  ///< as `told_apart` sorts them
};

/// How a device lies that does not lie well: sentences for the user, empty if all is well.
///
/// - off the wall: where neither sac nor branch opens (nor a sac in whose mouth the device ends),
/// it touches the wall on less than half of its
///   area, or lies more than three wire diameters off it on more than a tenth; with the largest gap
///   and its place, and, if the vessel is wider than the device, the size that would fit: the
///   smallest one made that is no narrower than the widest lumen behind it (2 x the median distance
///   of the wall from a ring's hub, which an opening does not change)
/// - an end that does not lie on the wall (`OpeningKind::end`), and whether it lies in a sac's
/// mouth
/// - across or in the ostium of a branch
/// - wires that are more than 1 % longer or shorter than they are made, which real ones are not,
///   with the length that wires of constant length would give the device,
///   L = sum over the gaps dL0 length_ratio(t, R / R0), R the mean radial expansion of the two
///   rings; left out where the schedule pushes, pulls or sets the spacing
///
/// @param wall  of the vessel, without other devices
/// @param unit  of places
std::vector<std::string> apposition_notes(const PlacedDevice& placed, const WallTree& wall,
                                          const LengthUnit& unit);

}  // namespace braidzone
