#include "discrepancy/effect.hpp"
#include "discrepancy/push_window.hpp"

namespace braidzone {

/// The operator pulled: rings were set further apart than nominal over a stretch.
///
/// The braid is thinner and narrower there, and the device longer. Prior of the change 0.25. Key:
/// deployment.push_pull.
Effect local_pull_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        return window_parameters(setting, 0.25, 0.0, 0.8);
    };
    const auto starts = [](const EffectSetting& setting) {
        return window_starts(setting, {0.2, 0.4});
    };
    return {"local_pull", "the operator pulled",
            true,         "the positions of the end markers, or a map of the wire density",
            parameters,   starts,
            with_window,  3.5};
}

}  // namespace braidzone
