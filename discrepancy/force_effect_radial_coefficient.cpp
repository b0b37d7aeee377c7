#include "discrepancy/force_effects.hpp"

namespace braidzone {

/// The radial springs are stiffer or softer than their coefficient says.
///
/// Raises the force most where the device is crushed, at the end of the curve. Prior 30 %:
/// coefficients of the same device from different sources. Key: press.radial_factor.
ForceEffect radial_coefficient_effect()
{
    return {{.name = "radial_coefficient",
             .title = "the radial coefficient is other than assumed",
             .parameters = {normal_parameter("change", "1", 0.0, 0.3, -0.6, 1.5)},
             .starts = {{0.0}},
             .needs_simulation = false,
             .separated_by = "the radial force between plates, or a longer stroke"},
            [](const PressModel& base, const std::vector<double>& x) {
                PressModel model = base;
                model.options.radial_factor *= 1.0 + x[0];
                return model;
            }};
}

}  // namespace braidzone
