#pragma once

#include "discrepancy/model.hpp"

#include <vector>

namespace braidzone {

/// Refuses measured points that cannot be compared with a simulated device.
///
/// @throws InputError if there are fewer than 50 points, or less than half of them lie within 2 mm
///         of the simulated device. The message says which unit would fit, or where along the
///         vessel the points lie, or how far from the vessel.
void require_comparable(const std::vector<Vec3>& points, const Imaging& imaging,
                        const Simulation& simulation, const Lumen& lumen);

}  // namespace braidzone
