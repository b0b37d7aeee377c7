#pragma once

#include "discrepancy/curve_problem.hpp"
#include "porous/pressure_bench.hpp"

#include <vector>

namespace braidzone {

using PressureEffect = CurveEffect<PressureBench>;

/// Effects that may be missing in the model of a bench's pressure drop, in the order in which
/// equals are reported: what concerns the bench first.
std::vector<PressureEffect> pressure_effects(const PressureBench& base);

// One file each.
PressureEffect viscosity_effect();
PressureEffect leakage_effect(const PressureBench& base);
PressureEffect missing_inertia_effect(const PressureBench& base);
PressureEffect density_effect();
PressureEffect second_layer_effect();

/// A bench with all of them, at measured velocities [m/s].
CurveBench<PressureBench> pressure_curve_bench(const PressureBench& base,
                                               const std::vector<double>& velocities);

}  // namespace braidzone
