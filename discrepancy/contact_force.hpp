#pragma once

#include "deploy/deployment.hpp"

namespace braidzone {

/// Radial force with which a stretch of a device presses on the wall [N]: the sum of the contact
/// forces of its rings. A ring stands for half of the gaps on both sides of it, and counts by the
/// share of that which lies in the stretch, so that the force changes smoothly as the device moves.
/// @param from, to  of the stretch on the centerline [m]; infinite: to the device's end
double contact_force(const Deployment& deployment, double from, double to);

}  // namespace braidzone
