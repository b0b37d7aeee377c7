#include "discrepancy/effect.hpp"

namespace braidzone {

/// The braid slid along the wall while it was released: friction is finite.
///
/// Rings that stick stay at the nominal spacing at which the catheter sets them down; a braid that
/// slides goes part of the way to the spacing at which it is free of force in the vessel
/// (`release_spacing.hpp`). It is longer, less dense, and bulges less into the neck. Prior 0.4
/// about what the case has: not much more is known of it than its bounds. Key: deployment.sliding.
Effect sliding_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        const double base = setting.base.schedule.sliding;
        return std::vector<EffectParameter>{normal_parameter("share", "1", base, 0.4, 0.0, 1.0)};
    };
    const auto starts = [](const EffectSetting& setting) {
        const double base = setting.base.schedule.sliding;
        return std::vector<std::vector<double>>{{base < 0.8 ? base + 0.2 : base - 0.2}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.schedule.sliding = x[0];
        validate(model.schedule);
        return model;
    };
    return {"sliding",  "the braid slid along the wall at its release",
            true,       "the implanted length, or a map of the wire density",
            parameters, starts,
            apply};
}

}  // namespace braidzone
