#pragma once

#include "discrepancy/explanation.hpp"
#include "discrepancy/further_measurement.hpp"
#include "discrepancy/surface_problem.hpp"

#include <vector>

namespace braidzone {

/// Which further measurement would tell the answers of a surface diagnosis apart, of those that
/// were not made: both ends, the implanted length, a density map, the force on the wall, with the
/// accuracy of `PlannedMeasurement`.
/// @return without pairs unless the verdict is ambiguous
FurtherMeasurement further_measurement_of(const SurfaceData& data,
                                          const std::vector<Effect>& catalogue,
                                          const Explanation& explanation);

}  // namespace braidzone
