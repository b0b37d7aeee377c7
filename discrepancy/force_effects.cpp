#include "discrepancy/force_effects.hpp"

namespace braidzone {

std::vector<ForceEffect> force_effects(const PressResponse& response)
{
    return {zero_offset_effect(),        friction_effect(response.base, response.slip),
            wire_diameter_effect(),      surface_coefficient_effect(),
            radial_coefficient_effect(), stiffening_effect()};
}

CurveBench<PressModel> force_curve_bench(const PressResponse& response,
                                         const std::vector<double>& displacements)
{
    return {response.base, force_effects(response),
            [response, displacements](const PressModel& model) {
                return press_forces(response, model, displacements);
            }};
}

}  // namespace braidzone
