#include "discrepancy/pressure_effects.hpp"

namespace braidzone {

/// There is a second layer of braid: another device inside the first, or a fold.
///
/// A layer more resists as much as the first, and 10 to 20 % more in touch with it
/// (`joined` in porous/resistance_sheet.hpp); prior 1.05 +- 0.1. Key: bench.second_layer.
PressureEffect second_layer_effect()
{
    return {{.name = "second_layer",
             .title = "there is a second layer of braid",
             .parameters = {normal_parameter("loss_ratio", "1", 1.05, 0.1, 0.0, 2.0)},
             .starts = {{1.05}},
             .needs_simulation = true,
             .separated_by = "a photograph of the mounted device against the light"},
            [](const PressureBench& base, const std::vector<double>& x) {
                PressureBench bench = base;
                bench.second_layer += x[0];
                return bench;
            }};
}

}  // namespace braidzone
