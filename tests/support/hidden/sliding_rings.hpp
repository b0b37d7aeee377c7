#pragma once

#include "support/hidden/braid_sheet.hpp"

#include <vector>

namespace braidzone::hidden {

/// Where the rings of a released device come to rest along the vessel if they slide.
///
/// The wires between two rings push them apart as long as the vessel holds the braid narrower than
/// its spacing allows; Coulomb's friction holds a ring with up to `friction` times its force on the
/// wall. With s the arc lengths, u their change and N the forces on the wall, the rings minimise
///
///     sum over gaps of W(s_i - s_(i+1)) + friction sum over rings of N_i sqrt(u_i^2 + d^2)
///
/// with W the energy of the wires between two rings at the radii they lie at, and friction rounded
/// over d = 5 um. The slopes of the radius along the device are left out of W.
///
/// @param released  arc lengths of the rows, distal first, decreasing [m]
/// @param radii     rows x columns [m]
/// @param force     of each row on the wall, in the units of the sheet's coefficients [N]
/// @return arc lengths at rest [m]
std::vector<double> slid_rings(const BraidSheet& sheet, const std::vector<double>& released,
                               const std::vector<double>& radii, const std::vector<double>& force,
                               double friction);

}  // namespace braidzone::hidden
