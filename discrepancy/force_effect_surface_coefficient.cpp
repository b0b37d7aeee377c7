#include "discrepancy/force_effects.hpp"

namespace braidzone {

/// The arms between crossings are stiffer or softer than their coefficient says, stretched and
/// bent.
///
/// Raises the force most where the device bends over the notch, before it is crushed. Prior 30 %:
/// coefficients of the same device from different sources. Key: press.surface_factor.
ForceEffect surface_coefficient_effect()
{
    return {{.name = "surface_coefficient",
             .title = "the surface coefficient is other than assumed",
             .parameters = {normal_parameter("change", "1", 0.0, 0.3, -0.6, 1.5)},
             .starts = {{0.0}},
             .needs_simulation = false,
             .separated_by = "a bending test of the device over a wider notch"},
            [](const PressModel& base, const std::vector<double>& x) {
                PressModel model = base;
                model.options.surface_factor *= 1.0 + x[0];
                return model;
            }};
}

}  // namespace braidzone
