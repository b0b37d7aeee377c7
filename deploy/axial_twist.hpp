#pragma once

#include "deploy/braid_lattice.hpp"

#include <vector>

namespace braidzone {

/// Torque at release: over a stretch of the centerline the rings are turned about the vessel's
/// axis, those proximal of it by the whole angle against those distal of it.
///
///     phi(s) = angle S((centre + half_width - s) / (2 half_width)),   S: `smooth_step`
///
/// Infinite friction keeps the nodes at the angles at which they were released, as it keeps their
/// ring spacing. With Delta the turn from one ring to the next and w the angle between the ends of
/// an arm (pi / n), the arms of one family of wires span w + Delta, those of the other w - Delta:
/// one becomes flatter, the other steeper. The wires of the flatter family need more length, which
/// they draw from the ends of the device, and the others give as much away. So both families are
/// free of force at the radius at which the mean square of the arms' lengths is what it was:
///
///     (R / R0)^2 = (1 - cos w) / (1 - cos w cos Delta),   nearly  1 / (1 + x^2),   x = Delta / w
///
/// at nominal ring spacing, where x = t R0 d phi / ds. That is the waist of a twisted braid in the
/// open; where the vessel is narrower, the braid only presses less. The radial springs rest at that
/// radius too: bending alone would narrow the braid to R0 / (1 + x^2), at which the mean curvature
/// of helices of both angles, cos^2 b / R, is that of the braid at rest. The sign of the angle does
/// not matter to the radius: mirrored, the families change places.
///
/// Arms that kept their lengths instead would be stretched in one family and pressed in the other,
/// which buckles in the lattice from x of about a third.
struct AxialTwist {
    double angle = 0.0;       ///< [rad]; positive: proximal rings turn about the downstream axis
    double centre = 0.0;      ///< arc length on the centerline [m]
    double half_width = 0.0;  ///< of the stretch [m]; > 0
};

/// @throws ConfigError if an angle or place is not finite, an angle exceeds two turns, or a stretch
///         has no width
void validate(const std::vector<AxialTwist>& twists);

/// Turn of a ring at a place on the centerline: the sum over the twists [rad].
double turn_at(const std::vector<AxialTwist>& twists, double arc_length);

/// Turns of rings [rad]; none without twists.
/// @param arc_lengths  of the rings on the centerline [m]
/// @throws ConfigError if two neighbouring rings are turned against each other by as much as an arm
///         spans: one family of wires would lie along the vessel, which no braid reaches
std::vector<double> ring_turns(const std::vector<AxialTwist>& twists, const BraidLattice& lattice,
                               const std::vector<double>& arc_lengths);

/// The lattice of a braid whose rings are turned: its force-free radii, and the force-free lengths
/// of its arms at them, so that the lattice is free of force as it is turned, at its own ring
/// spacing. The radius of a ring is the mean of those of the gaps before and behind it.
BraidLattice twisted(const BraidLattice& lattice, const std::vector<double>& turns);

}  // namespace braidzone
