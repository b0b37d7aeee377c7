#pragma once

#include "discrepancy/effect_parameter.hpp"
#include "discrepancy/model.hpp"

#include <functional>
#include <string>
#include <vector>

namespace braidzone {

/// What an effect starts from: the case as it is, and where its device lies.
struct EffectSetting {
    Model base;
    double from = 0.0;           ///< proximal end of the simulated device, arc length [m]
    double to = 0.0;             ///< distal end [m]
    Vec3 middle = Vec3::Zero();  ///< of the measured points [m]
};

/// Something that may be missing in a case: a change of the deployment or of the imaging with a few
/// parameters, never a patch on the surface. Each stands in a file of its own, `effect_<name>.cpp`,
/// and in the list of `effect_catalogue`.
struct Effect {
    std::string name;          ///< "local_push"
    std::string title;         ///< for people: "the operator pushed"
    bool changes_deployment;   ///< false: only how the device was seen
    std::string separated_by;  ///< a measurement that would tell it from others
    std::function<std::vector<EffectParameter>(const EffectSetting&)> parameters;
    /// Where fits begin, each a value for each parameter; the first parameter is the amplitude.
    std::function<std::vector<std::vector<double>>(const EffectSetting&)> starts;
    /// The base model with the effect. @throws ConfigError if it cannot stand beside what is there
    std::function<Model(const EffectSetting&, const std::vector<double>&)> apply;
    /// `Candidate::interval_factor`: learned from simulated measurements in which the effect was
    /// made by another program, so that 90 % of its 90 % intervals hold the truth.
    double interval_factor = 1.0;
};

/// All effects, in the order in which equals are reported: what concerns the imaging first.
const std::vector<Effect>& effect_catalogue();

// One file each.
Effect registration_effect();
Effect blooming_effect();
Effect vessel_offset_effect();
Effect wall_compliance_effect();
Effect vessel_straightening_effect();
Effect landing_offset_effect();
Effect nominal_diameter_effect();
Effect braid_ratio_effect();
Effect local_push_effect();
Effect local_pull_effect();
Effect sliding_effect();
Effect axial_twist_effect();
Effect incomplete_opening_proximal_effect();
Effect incomplete_opening_distal_effect();
Effect free_hub_effect();

}  // namespace braidzone
