#include "discrepancy/effect.hpp"

#include <numbers>

namespace braidzone {

/// The scan lies elsewhere than its registration says, by more than the noise floor's prior.
///
/// A rigid motion of the measured points about their middle, applied exactly: three shifts and
/// three turns. Its standard deviations are four times those of a registration that went well
/// (prototype: 0.07 mm, 0.75 degrees). Keys: measurement.shift, rotation, pivot.
Effect registration_effect()
{
    const auto parameters = [](const EffectSetting&) {
        constexpr double degree = std::numbers::pi / 180.0;
        std::vector<EffectParameter> all;
        for (const char* axis : {"x", "y", "z"}) {
            all.push_back(
                normal_parameter(std::string("shift_") + axis, "mm", 0.0, 0.3e-3, -1.5e-3, 1.5e-3));
        }
        for (const char* axis : {"x", "y", "z"}) {
            all.push_back(normal_parameter(std::string("rotation_") + axis, "deg", 0.0,
                                           3.0 * degree, -15.0 * degree, 15.0 * degree));
        }
        return all;
    };
    const auto starts = [](const EffectSetting&) {
        return std::vector<std::vector<double>>{std::vector<double>(6, 0.0)};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        model.imaging.pivot = setting.middle;
        model.imaging.shift = Vec3(x[0], x[1], x[2]);
        model.imaging.rotation = Vec3(x[3], x[4], x[5]);
        return model;
    };
    return {"registration", "the scan is misplaced",
            false,          "fiducials or a landmark seen in both scans",
            parameters,     starts,
            apply,          1.5};
}

}  // namespace braidzone
