#include "discrepancy/effect.hpp"

namespace braidzone {

/// The device landed further up or down the vessel than planned.
///
/// Its surface hardly shows it, its ends do. Prior 1 mm. Key: deployment.landing_distal.
Effect landing_offset_effect()
{
    const auto parameters = [](const EffectSetting&) {
        return std::vector<EffectParameter>{
            normal_parameter("offset", "mm", 0.0, 1e-3, -5e-3, 5e-3)};
    };
    const auto starts = [](const EffectSetting&) {
        return std::vector<std::vector<double>>{{0.0}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.landing_distal += x[0];
        return model;
    };
    return {"landing_offset",
            "the device landed elsewhere",
            true,
            "the positions of the end markers",
            parameters,
            starts,
            apply,
            1.4};
}

}  // namespace braidzone
