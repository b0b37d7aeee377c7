#include "discrepancy/force_effects.hpp"

namespace braidzone {

/// The head's zero is not where it touches the device.
///
/// The curve is shifted along the displacement. Prior 0.1 mm: where contact is seen with the eye,
/// or by the first force above the cell's noise. Key: press.zero_offset.
ForceEffect zero_offset_effect()
{
    return {{.name = "zero_offset",
             .title = "the head's zero is not where it touches the device",
             .parameters = {normal_parameter("offset", "mm", 0.0, 0.1e-3, -0.3e-3, 0.5e-3)},
             .starts = {{0.0}},
             .needs_simulation = false,
             .separated_by = "more points near the first contact"},
            [](const PressModel& base, const std::vector<double>& x) {
                PressModel model = base;
                model.options.reading.zero_offset += x[0];
                return model;
            }};
}

}  // namespace braidzone
