#include "discrepancy/effect.hpp"

namespace braidzone {

/// The vessel is wider or narrower than its surface says.
///
/// The threshold of the lumen's segmentation moves its wall along the normals by one distance; the
/// device follows where it lies on the wall and bridges the neck as before, a little wider. Prior
/// 0.1 mm: half a voxel. Key: vessel.wall_offset.
Effect vessel_offset_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        const double base = setting.base.wall_offset;
        return std::vector<EffectParameter>{
            normal_parameter("wall_offset", "mm", base, 0.1e-3, base - 0.4e-3, base + 0.4e-3)};
    };
    const auto starts = [](const EffectSetting& setting) {
        return std::vector<std::vector<double>>{{setting.base.wall_offset}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.wall_offset = x[0];
        return model;
    };
    return {"vessel_offset",
            "the lumen is segmented too wide or too narrow",
            true,
            "a second scan of the vessel before the deployment, or a caliper of known size",
            parameters,
            starts,
            apply,
            1.3};
}

}  // namespace braidzone
