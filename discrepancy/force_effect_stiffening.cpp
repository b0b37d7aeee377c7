#include "discrepancy/force_effects.hpp"

namespace braidzone {

/// The device stiffens as it is pressed, beyond what its shape makes it do: wires that lock at
/// their crossings.
///
/// Forces grow by the factor 1 + k x / D with the way x of the head over the diameter D. Prior
/// k = 0.3: as much at a stroke of a diameter as springs are uncertain. Key: press.stiffening.
ForceEffect stiffening_effect()
{
    return {{.name = "stiffening",
             .title = "the device stiffens as it is pressed",
             .parameters = {normal_parameter("k", "1", 0.0, 0.3, -0.8, 2.0)},
             .starts = {{0.0}},
             .needs_simulation = false,
             .separated_by = "a second stroke after the first, or one at another speed"},
            [](const PressModel& base, const std::vector<double>& x) {
                PressModel model = base;
                model.options.reading.stiffening += x[0];
                return model;
            }};
}

}  // namespace braidzone
