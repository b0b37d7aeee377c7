#include "discrepancy/pressure_effects.hpp"

namespace braidzone {

/// The device is deployed more or less densely than assumed: its rings are closer or wider apart,
/// with them braid angle and metal coverage.
///
/// Both parts of the loss grow with the density, the linear one faster. Prior 0.25: what a push
/// changes. Key: bench.density_increase.
PressureEffect density_effect()
{
    return {{.name = "density",
             .title = "the device is deployed more or less densely than assumed",
             .parameters = {normal_parameter("density_change", "1", 0.0, 0.25, -0.5, 1.5)},
             .starts = {{0.0}},
             .needs_simulation = true,
             .separated_by = "pore density or implanted length of the device on the bench, from a "
                             "photograph or a micro-CT"},
            [](const PressureBench& base, const std::vector<double>& x) {
                PressureBench bench = base;
                bench.density_increase = (1.0 + base.density_increase) * (1.0 + x[0]) - 1.0;
                return bench;
            }};
}

}  // namespace braidzone
