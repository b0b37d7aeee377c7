#include "discrepancy/effect.hpp"

namespace braidzone {

/// Rings lie nearer to their open side than the balance of their springs has them.
///
/// Wires that slide around their rings gather in front of a neck, and the rings shift into it as a
/// whole: the braid bulges further there while its length and the wall's side stay
/// (`hub_shift.hpp`). Prior 0.1 mm: lobes of 0.1 to 0.2 mm beside a pinned opposite wall are what
/// comparisons with real devices leave. Key: deployment.hub_shift.
Effect free_hub_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        const double base = setting.base.options.hub_shift;
        return std::vector<EffectParameter>{
            normal_parameter("shift", "mm", base, 0.1e-3, 0.0, base + 0.5e-3)};
    };
    const auto starts = [](const EffectSetting& setting) {
        return std::vector<std::vector<double>>{{setting.base.options.hub_shift + 0.1e-3}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.options.hub_shift = x[0];
        return model;
    };
    return {"free_hub", "the rings have shifted into the neck",
            true,       "a map of the braid angle around the device in front of the neck",
            parameters, starts,
            apply,      1.7};
}

}  // namespace braidzone
