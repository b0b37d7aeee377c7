#include "discrepancy/force_effects.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {

/// The device rubs on head and block.
///
/// Coulomb's friction between wires and bench raises the force by some 2 % for each 0.1, and makes
/// the curve rough, as crossings stick and slip one by one: by as much again, from one point to the
/// next. That scatter tells its size, and less well than a fit believes: to hold 90 % of 24
/// simulated tests intervals had to be 2.5 times as wide. Prior 0.25: metal on metal, dry. Key:
/// press.friction.
ForceEffect friction_effect(const PressModel& base, double slip)
{
    const double present = base.options.friction;
    return {{.name = "friction",
             .title = "the device rubs on head and block",
             .parameters = {normal_parameter("coefficient", "1", 0.0, 0.25, -present, 0.8)},
             .starts = {{0.1}},
             .needs_simulation = false,
             .separated_by = "the force while the head goes back, or a run with wetted surfaces",
             .interval_factor = 2.5},
            [](const PressModel& before, const std::vector<double>& x) {
                PressModel model = before;
                model.options.friction = std::max(0.0, model.options.friction + x[0]);
                return model;
            },
            [slip](const std::vector<double>& x) { return slip * std::abs(x[0]); }};
}

}  // namespace braidzone
