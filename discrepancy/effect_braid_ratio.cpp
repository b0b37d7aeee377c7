#include "discrepancy/effect.hpp"

namespace braidzone {

/// The wires are braided more or less steeply than the library says (dL/dR).
///
/// At nominal release spacing it changes the density, and of the surface only the bulge in the
/// neck. Prior 8 % of the ratio. Key: device.braid_ratio.
Effect braid_ratio_effect()
{
    const auto parameters = [](const EffectSetting&) {
        return std::vector<EffectParameter>{
            normal_parameter("relative_change", "1", 0.0, 0.08, -0.3, 0.3)};
    };
    const auto starts = [](const EffectSetting&) {
        return std::vector<std::vector<double>>{{0.0}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.device.braid_ratio *= 1.0 + x[0];
        return model;
    };
    return {"braid_ratio", "the braid's angle differs from the library's",
            true,          "a map of the wire density, or a photograph of the braid",
            parameters,    starts,
            apply};
}

}  // namespace braidzone
