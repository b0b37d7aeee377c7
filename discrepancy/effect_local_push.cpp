#include "discrepancy/effect.hpp"
#include "discrepancy/push_window.hpp"

namespace braidzone {

/// The operator pushed: rings were set closer than nominal over a stretch.
///
/// The braid is denser there and, in front of a neck, bulges into it; the device becomes shorter
/// (Zavodszky et al. 2020, section 3.2). The change of the spacing is -0.66 in that paper; prior
/// 0.4. Key: deployment.push_pull.
Effect local_push_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        return window_parameters(setting, 0.4, -0.85, 0.0);
    };
    const auto starts = [](const EffectSetting& setting) {
        return window_starts(setting, {-0.3, -0.55});
    };
    return {"local_push", "the operator pushed",
            true,         "the positions of the end markers, or a map of the wire density",
            parameters,   starts,
            with_window,  3.5};
}

}  // namespace braidzone
