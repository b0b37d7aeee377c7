#include "discrepancy/force_effects.hpp"

#include <cmath>

namespace braidzone {

/// The wires are thicker or thinner than stated.
///
/// All forces go with the fourth power of the diameter, as bending EI and torsion GJ do: by wire
/// theory, and for springs too, which stand for both; stretching, EA, costs too much to take part.
/// The shape of the curve stays. Prior 5 %: a micrometre and a half in 30. Keys:
/// device.wire_diameter; for springs press.surface_factor and press.radial_factor as well.
ForceEffect wire_diameter_effect()
{
    return {{.name = "wire_diameter",
             .title = "the wires are thicker or thinner than stated",
             .parameters = {normal_parameter("change", "1", 0.0, 0.05, -0.2, 0.2)},
             .starts = {{0.0}},
             .needs_simulation = false,
             .separated_by = "the wires' diameter under a microscope, or the weight of a piece"},
            [](const PressModel& base, const std::vector<double>& x) {
                PressModel model = base;
                model.device.wire_diameter *= 1.0 + x[0];
                if (model.device.forces == ForceSource::springs) {
                    const double stiffer = std::pow(1.0 + x[0], 4);
                    model.options.surface_factor *= stiffer;
                    model.options.radial_factor *= stiffer;
                }
                return model;
            }};
}

}  // namespace braidzone
