#include "discrepancy/effect.hpp"

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

/// The paper's mean contact pressure, 33 mmHg (Zavodszky et al. 2020, Table 3) [Pa].
constexpr double typical_pressure = 4400.0;

/// A wall that is displaced by less counts as rigid: it would need very small time steps [m].
constexpr double smallest_displacement = 2e-6;

double compliance_of(const DeployOptions& options)
{
    return std::isfinite(options.wall_stiffness) ? 1.0 / options.wall_stiffness : 0.0;
}

}  // namespace

/// The wall gives way where the device presses on it.
///
/// displacement = pressure / wall_stiffness; the parameter is the displacement at a typical contact
/// pressure of 4.4 kPa, on top of what the case has. Prior 0.1 mm: an intracranial artery of 2 mm
/// radius widens by some per cent of it. Key: deployment.wall_stiffness.
Effect wall_compliance_effect()
{
    const auto parameters = [](const EffectSetting&) {
        return std::vector<EffectParameter>{
            normal_parameter("displacement", "mm", 0.0, 0.1e-3, 0.0, 0.4e-3)};
    };
    const auto starts = [](const EffectSetting&) {
        return std::vector<std::vector<double>>{{0.03e-3}};
    };
    const auto apply = [](const EffectSetting& setting, const std::vector<double>& x) {
        Model model = setting.base;
        if (x[0] < smallest_displacement) return model;
        model.options.wall_stiffness =
            1.0 / (compliance_of(setting.base.options) + x[0] / typical_pressure);
        return model;
    };
    return {"wall_compliance",
            "the wall gives way",
            true,
            "a second scan of the vessel after the deployment",
            parameters,
            starts,
            apply,
            2.2};
}

}  // namespace braidzone
