#include "discrepancy/effect.hpp"

namespace braidzone {

/// The segmented device looks thicker or thinner than its wires' mid-surface, or, where the imaging
/// chain of the volume is known, than that chain makes it.
///
/// Partial volumes and the threshold of the segmentation move the whole surface along its normal by
/// one distance. Prior 0.1 mm: half a voxel of a C-arm scan. Key: measurement.blooming.
Effect blooming_effect()
{
    const auto parameters = [](const EffectSetting& setting) {
        const double base = setting.base.imaging.blooming;
        return std::vector<EffectParameter>{
            normal_parameter("blooming", "mm", base, 0.1e-3, base - 0.5e-3, base + 0.5e-3)};
    };
    const auto starts = [](const EffectSetting& setting) {
        return std::vector<std::vector<double>>{{setting.base.imaging.blooming}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.imaging.blooming = x[0];
        return model;
    };
    return {"blooming", "the device is segmented too thick or too thin",
            false,      "a caliper of known size in the scan, or the positions of the end markers",
            parameters, starts,
            apply,      1.2};
}

}  // namespace braidzone
