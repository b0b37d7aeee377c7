#include "discrepancy/pressure_effects.hpp"

namespace braidzone {

std::vector<PressureEffect> pressure_effects(const PressureBench& base)
{
    return {viscosity_effect(), leakage_effect(base), missing_inertia_effect(base),
            density_effect(), second_layer_effect()};
}

CurveBench<PressureBench> pressure_curve_bench(const PressureBench& base,
                                               const std::vector<double>& velocities)
{
    return {base, pressure_effects(base), [velocities](const PressureBench& bench) {
                std::vector<double> drops;
                for (const double velocity : velocities)
                    drops.push_back(bench_pressure_drop(bench, velocity));
                return drops;
            }};
}

}  // namespace braidzone
