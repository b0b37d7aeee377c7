#pragma once

#include "deploy/deployment.hpp"

namespace braidzone {

/// By how much a deployment changes the length of the wires. Real wires keep theirs, and with it
/// the device its metal: what is stretched here is the give of the model's springs, and of rings
/// that are held at their places along the vessel.
struct WireStretch {
    double total = 0.0;    ///< length of all wires over that of the force-free device, minus 1 [-]
    double lowest = 0.0;   ///< of the arm between two crossings that is shortened most [-]
    double highest = 0.0;  ///< of the arm that is lengthened most [-]
};

/// The stretch of a deployed device,
///
///     total = sum |x_i - x_j| / (number of arms l0) - 1
///
/// over the arms i-j of its lattice; l0 is their force-free length, also in flares.
WireStretch wire_stretch(const Deployment& deployment);

}  // namespace braidzone
