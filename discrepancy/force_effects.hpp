#pragma once

#include "discrepancy/curve_problem.hpp"
#include "discrepancy/press_response.hpp"

#include <vector>

namespace braidzone {

using ForceEffect = CurveEffect<PressModel>;

/// Effects that may be missing in the model of a press test, in the order in which equals are
/// reported: what concerns the bench first.
std::vector<ForceEffect> force_effects(const PressResponse& response);

// One file each.
ForceEffect zero_offset_effect();
/// @param slip  scatter per unit of friction (`PressResponse::slip`)
ForceEffect friction_effect(const PressModel& base, double slip);
ForceEffect wire_diameter_effect();
ForceEffect surface_coefficient_effect();
ForceEffect radial_coefficient_effect();
ForceEffect stiffening_effect();

/// A press test with all of them, at measured displacements [m].
CurveBench<PressModel> force_curve_bench(const PressResponse& response,
                                         const std::vector<double>& displacements);

}  // namespace braidzone
