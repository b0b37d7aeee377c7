#include "discrepancy/force_effects.hpp"

#include <algorithm>

namespace braidzone {

/// The device rubs on head and block.
///
/// Coulomb's friction between wires and bench raises the force by some 3 % for each 0.1, most
/// where the device slides over the edges of the notch. Prior 0.25: metal on metal, dry. Key:
/// press.friction.
ForceEffect friction_effect(const PressModel& base)
{
    const double present = base.options.friction;
    return {{.name = "friction",
             .title = "the device rubs on head and block",
             .parameters = {normal_parameter("coefficient", "1", 0.0, 0.25, -present, 0.8)},
             .starts = {{0.1}},
             .needs_simulation = false,
             .separated_by = "the force while the head goes back, or a run with wetted surfaces"},
            [](const PressModel& before, const std::vector<double>& x) {
                PressModel model = before;
                model.options.friction = std::max(0.0, model.options.friction + x[0]);
                return model;
            }};
}

}  // namespace braidzone
