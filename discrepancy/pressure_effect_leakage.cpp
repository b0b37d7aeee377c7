#include "discrepancy/pressure_effects.hpp"

#include <algorithm>

namespace braidzone {

/// Fluid leaks past the braid's edge, through a slit beside it (`porous/edge_gap.hpp`).
///
/// A slit of less than some 0.13 mm lets no more through than the braid that it takes the place of;
/// a wider one lowers the loss, most at slow flow. Prior 0.2 mm: what is seen with the eye. Key:
/// bench.gap.
PressureEffect leakage_effect(const PressureBench& base)
{
    const double widest = std::min(0.8e-3, 0.2 * base.channel_diameter);
    return {
        {.name = "leakage",
         .title = "fluid leaks past the edge of the device",
         .parameters = {normal_parameter("gap", "mm", 0.0, 0.2e-3, -base.gap_width, widest)},
         .starts = {{0.2 * widest}, {0.4 * widest}, {0.7 * widest}},
         .needs_simulation = true,
         .separated_by = "a run with the edge sealed, or one with a closed foil in the place of "
                         "the device"},
        [](const PressureBench& before, const std::vector<double>& x) {
            PressureBench bench = before;
            bench.gap_width = std::max(0.0, bench.gap_width + x[0]);
            return bench;
        }};
}

}  // namespace braidzone
