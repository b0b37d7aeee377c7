#include "discrepancy/pressure_effects.hpp"

namespace braidzone {

/// The fluid is more or less viscous than stated, as one of another temperature is.
///
/// The linear part of the loss is proportional to the viscosity, the quadratic one does not depend
/// on it. Prior 12 %: mixtures of water and glycerol lose about 3 % a kelvin (water 2 %), and gain
/// about 5 % from a hundredth more of glycerol. Key: fluid.viscosity.
PressureEffect viscosity_effect()
{
    return {{.name = "viscosity",
             .title = "the fluid is more or less viscous than stated, or of another temperature",
             .parameters = {normal_parameter("change", "1", 0.0, 0.12, -0.5, 1.0)},
             .starts = {{0.0}},
             .needs_simulation = true,
             .separated_by = "the fluid's temperature during the run, or its viscosity in a "
                             "viscometer"},
            [](const PressureBench& base, const std::vector<double>& x) {
                PressureBench bench = base;
                bench.fluid.viscosity *= 1.0 + x[0];
                return bench;
            }};
}

}  // namespace braidzone
