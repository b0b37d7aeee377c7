#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"
#include "deploy/braid_lattice.hpp"
#include "deploy/flow_diverter.hpp"
#include "deploy/release_schedule.hpp"

#include <vector>

namespace braidzone {

/// Radii at which the nodes of a ring would rest in the vessel [m], in 48 directions from the
/// normal of the cross-section to its binormal and on: min(wall distance along the ray, R0), from
/// the origin of the cross-section, in its plane.
/// @param nominal_radius  R0 [m]
std::vector<double> resting_radii(const CrossSection& section, const WallTree& wall,
                                  double nominal_radius);

/// Ring spacing at which the wires keep their length in the vessel, as a table along the
/// centerline. With r(phi) the `resting_radii`, an arm of the braid at a spacing L spans
///
///     a = L d/ds (hub + r e_r)  +-  (pi r / n) e_phi
///
/// and lambda(s) = L / dL0 is where the mean of |a| over phi and both wires is that of the
/// force-free device, sqrt(dL0^2 + dR0^2). In a straight tube
///
///     lambda = length_ratio(t, r / R0) = sqrt(1 + (1 - (r / R0)^2) / t^2)
///
/// so that a braid which may slide while it is released lengthens where the vessel holds it
/// narrower than nominal: 1.3 times for 10 % less diameter of a 4 mm Pipeline. In a bend of
/// curvature kappa the arms outside grow by more than those inside shrink, by (dR^2 / l^3) L^2
/// (kappa r)^2 / 4 on average, and rings lie closer: by 12 % on the centerline in a bend as tight
/// as the vessel is wide. Planes that would cross are tilted (`ring_planes.hpp`).
///
/// The table has points every nominal ring spacing from the distal end down to where the device
/// must have ended: exact in a straight tube, of second order in the ring spacing where the radius
/// changes (`ring_positions` integrates a piecewise linear table exactly). Changes of the radius
/// along the vessel do not count for an arm's length.
///
/// With a flare R0 in r is the widest radius of the device, and lambda falls below 1 where the
/// vessel is wider than nominal. lambda is never below what leaves the wires apart
/// (`wire_jam.hpp`).
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
