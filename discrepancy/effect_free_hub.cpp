#include "discrepancy/effect.hpp"

namespace braidzone {

/// Rings find their own place in the lumen instead of staying in its middle.
///
/// The hub of a ring's radial springs gives way to them (`opening_braid.hpp`): where the wall holds
/// the ring on one side only, it shifts into the open side, and the braid bulges further into a
/// neck. Of the paper's two migrations it is that of the whole ring; that of its nodes around the
/// ring is `deployment.hoop_migration`, which has no continuous counterpart. In a vessel that holds
/// the ring all around but for a neck it moves the surface by some micrometres only, and will be
/// found to be one that cannot be told. Prior 0.5 of a free hub. Key: deployment.hub_freedom.
Effect free_hub_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        return std::vector<EffectParameter>{
            normal_parameter("freedom", "1", setting.base.options.hub_freedom, 0.5, 0.0, 1.0)};
    };
    const auto starts = [](const EffectSetting& setting) {
        const double base = setting.base.options.hub_freedom;
        return std::vector<std::vector<double>>{{base < 0.5 ? base + 0.4 : base - 0.4}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.options.hub_freedom = x[0];
        return model;
    };
    return {"free_hub", "the rings' hubs give way",
            true,       "contact forces on the wall beside and across from the neck",
            parameters, starts,
            apply};
}

}  // namespace braidzone
