#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"
#include "deploy/braid_lattice.hpp"
#include "deploy/flow_diverter.hpp"
#include "deploy/release_schedule.hpp"

#include <vector>

namespace braidzone {

/// Radius at which a ring would rest in the vessel [m]:
///
///     R_local = mean over directions of min(wall distance along the ray, R0)
///
/// from the origin of the cross-section, in its plane.
/// @param nominal_radius  R0 [m]
double resting_radius(const CrossSection& section, const WallTree& wall, double nominal_radius);

/// Ring spacing at which the braid is free of force in the vessel, as a table along the centerline:
///
///     lambda(s) = length_ratio(t, R_local(s) / R0) = sqrt(1 + (1 - (R_local / R0)^2) / t^2)
///
/// A braid that may slide while it is released lengthens by this much where the vessel holds it
/// narrower than nominal: 1.3 times for 10 % less diameter of a 4 mm Pipeline. Curvature does not
/// count: arms along the outside of a bend would grow by more than those inside shrink, but what
/// grows leaves the wall there, and both together keep the wires' length and the network's within 1
/// % (tests/verification/bends).
///
/// The table has points every nominal ring spacing from the distal end down to where the device
/// must have ended: exact in a straight tube, of second order in the ring spacing where the radius
/// changes (`ring_positions` integrates a piecewise linear table exactly).
///
/// With a flare R0 in R_local is the widest radius of the device, and lambda falls below 1 where
/// the vessel is wider than nominal.
///
/// @param schedule        its windows, which multiply the spacing, decide how far down to look
/// @param landing_distal  arc length of the distal end [m]
/// @param centred         hubs in the middle of the lumen (`ring_centring.hpp`), else on the
///                        centerline
std::vector<SpacingPoint> force_free_spacing(const FlowDiverter& device,
                                             const BraidLattice& lattice,
                                             const Centerline& centerline, const WallTree& wall,
                                             const ReleaseSchedule& schedule, double landing_distal,
                                             bool centred);

/// Arc lengths at which the rings of a device are released in a vessel [m], by its schedule:
/// `ring_positions`, and if rings slide, with a table between the nominal spacing and the one
/// above,
///
///     lambda(s) = 1 + sliding (lambda_free(s) - 1)
///
/// Infinite friction, sliding 0, leaves the rings where the catheter sets them down, at nominal
/// spacing (Zavodszky et al. 2020, section 2.2). Without friction, sliding 1, no axial force
/// remains in the braid. Between them, the share is that of the axial force of the arms which the
/// friction at the wall could not hold: for small changes of spacing that force grows in
/// proportion to lambda_free - lambda.
///
/// A ring of a flare or cone is spaced as at rest, and slides from there where the wall holds it
/// narrower.
///
/// However hard the operator pushes, rings stay `least_plane_gap` apart (`wire_jam.hpp`), where
/// their wires nearly touch: 0.18 times the nominal spacing of a 4 mm Pipeline. Rings behind such a
/// place lie so much further on.
std::vector<double> release_positions(const FlowDiverter& device, const BraidLattice& lattice,
                                      const Centerline& centerline, const WallTree& wall,
                                      const ReleaseSchedule& schedule, double landing_distal,
                                      bool centred);

}  // namespace braidzone
