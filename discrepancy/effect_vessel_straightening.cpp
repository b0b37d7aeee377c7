#include "core/error.hpp"
#include "discrepancy/effect.hpp"

#include <algorithm>

namespace braidzone {

/// The device straightened the vessel that it lies in.
///
/// A share of the curvature over a window goes (`vessel_straightening.hpp`); the vessel around the
/// device as a whole stays where it was. The window has a place and a width, since bends give way
/// one by one. That vessels change their shape is one of two causes that were named for devices
/// whose length was predicted wrongly (Bouillot et al. 2016, AJNR 37:2079). Prior of the share 0.3:
/// a soft braid is not expected to take more than half of a bend away. Needs a case without
/// straightening of its own. Key: vessel.straightening.
Effect vessel_straightening_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        const double length = setting.to - setting.from;
        EffectParameter half_width = normal_parameter(
            "half_width", "mm", 0.5 * length, 0.25 * length, std::min(3e-3, 0.5 * length), length);
        half_width.step = 0.05 * length;
        return std::vector<EffectParameter>{
            normal_parameter("share", "1", 0.0, 0.3, 0.0, 0.9),
            uniform_parameter("centre", "mm", setting.from, setting.to, 0.05 * length), half_width};
    };
    const auto starts = [](const EffectSetting& setting) {
        const double length = setting.to - setting.from;
        std::vector<std::vector<double>> all;
        for (const double place : {0.25, 0.5, 0.75})
            all.push_back({0.2, setting.from + place * length, 0.3 * length});
        all.push_back({0.2, setting.from + 0.5 * length, 0.8 * length});
        return all;
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        if (x[0] == 0.0) return model;
        if (model.straightening.share > 0.0) {
            throw ConfigError(
                "vessel.straightening is in the case already; a second one cannot stand beside it");
        }
        model.straightening = {.share = x[0],
                               .centre = x[1],
                               .half_width = x[2],
                               .kept_from = setting.from,
                               .kept_to = setting.to};
        return model;
    };
    return {"vessel_straightening",
            "the device straightened the vessel",
            true,
            "a second scan of the vessel after the deployment",
            parameters,
            starts,
            apply,
            4.0};
}

}  // namespace braidzone
