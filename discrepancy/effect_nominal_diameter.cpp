#include "discrepancy/effect.hpp"

namespace braidzone {

/// The device is wider or narrower at rest than its label says.
///
/// It bulges more or less into the neck. Prior 0.2 mm: labels come in steps of 0.25 mm. Key:
/// device.diameter.
Effect nominal_diameter_effect()
{
    const auto parameters = [](const EffectSetting&) {
        return std::vector<EffectParameter>{
            normal_parameter("change", "mm", 0.0, 0.2e-3, -0.8e-3, 0.8e-3)};
    };
    const auto starts = [](const EffectSetting&) {
        return std::vector<std::vector<double>>{{0.0}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.device.nominal_diameter += x[0];
        return model;
    };
    return {"nominal_diameter",
            "the device is wider or narrower than its label",
            true,
            "the implanted length, or the diameter of a device of that batch on the bench",
            parameters,
            starts,
            apply,
            3.8};
}

}  // namespace braidzone
