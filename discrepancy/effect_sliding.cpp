#include "discrepancy/effect.hpp"

namespace braidzone {

/// The braid slid along the wall while it was released: friction is finite.
///
/// Rings that stick stay at the nominal spacing at which the catheter sets them down; a braid that
/// slides goes part of the way to the spacing at which it is free of force in the vessel
/// (`release_spacing.hpp`). It is longer, less dense, and bulges less into the neck. Where it has
/// slid to is not known with it: a braid that is laid down from its distal end keeps that, one that
/// relaxes after its release moves both ends, so the landing is a parameter too. Prior of the share
/// 0.4 about what the case has, as not much more is known of it than its bounds; of the landing 1
/// mm. Keys: deployment.sliding, landing_distal.
Effect sliding_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        const double base = setting.base.schedule.sliding;
        return std::vector<EffectParameter>{
            normal_parameter("share", "1", base, 0.4, 0.0, 1.0),
            normal_parameter("landing", "mm", 0.0, 1e-3, -5e-3, 5e-3)};
    };
    const auto starts = [](const EffectSetting& setting) {
        const double base = setting.base.schedule.sliding;
        return std::vector<std::vector<double>>{{base < 0.8 ? base + 0.2 : base - 0.2, 0.0}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.schedule.sliding = x[0];
        model.landing_distal += x[1];
        validate(model.schedule);
        return model;
    };
    return {"sliding",  "the braid slid along the wall at its release",
            true,       "the implanted length, or a map of the wire density",
            parameters, starts,
            apply};
}

}  // namespace braidzone
