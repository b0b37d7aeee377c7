#pragma once

#include "discrepancy/measured_scalars.hpp"
#include "discrepancy/model.hpp"

#include <vector>

namespace braidzone {

/// Refuses measured points that cannot be compared with a simulated device.
///
/// @throws InputError if there are fewer than 50 points, less than half of them lie within 1.5 mm
/// of
///         the simulated device, or they span less than a fifth or more than three times of it. The
///         message says which unit would fit, or where along the vessel the points lie, or how far
///         from the vessel.
void require_comparable(const std::vector<Vec3>& points, const Imaging& imaging,
                        const Simulation& simulation, const Lumen& lumen);

/// Refuses a measured force on a stretch of the vessel where the simulated device does not lie.
/// @throws InputError with both stretches
void require_force_on_device(const MeasuredScalars& scalars, const Deployment& deployment);

}  // namespace braidzone
