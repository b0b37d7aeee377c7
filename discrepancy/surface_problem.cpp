#include "discrepancy/surface_problem.hpp"

#include "discrepancy/channel_errors.hpp"
#include "discrepancy/registered_residuals.hpp"

#include <algorithm>

namespace braidzone {

Model model_with(const std::vector<Effect>& catalogue, const EffectSetting& setting,
                 const std::vector<ActiveEffect>& effects)
{
    EffectSetting with = setting;
    for (const ActiveEffect& effect : effects)
        with.base = catalogue[effect.candidate].apply(with, effect.values);
    return with.base;
}

DiagnosisProblem surface_problem(const SurfaceData& data, const std::vector<Effect>& catalogue)
{
    DiagnosisProblem problem;
    for (const Effect& effect : catalogue) {
        problem.candidates.push_back({effect.name, effect.title, effect.parameters(data.setting),
                                      effect.starts(data.setting), effect.changes_deployment,
                                      effect.separated_by, effect.interval_factor});
    }
    const RegisteredResiduals residuals_of(data.observations, data.error, data.base,
                                           data.setting.base.imaging);
    problem.residuals = [data, residuals_of, catalogue](const std::vector<ActiveEffect>& effects) {
        const Model model = model_with(catalogue, data.setting, effects);
        const bool must_deploy =
            std::any_of(effects.begin(), effects.end(), [&](const ActiveEffect& effect) {
                return catalogue[effect.candidate].changes_deployment;
            });
        if (!must_deploy) return residuals_of(data.base, model.imaging);
        return residuals_of(simulate(model, data.lumen), model.imaging);
    };
    problem.covariance = data.error.covariance();
    problem.nuisance =
        data.error.motion * data.error.motion_variance.asDiagonal() * data.error.motion.transpose();
    problem.distances = patch_distances(data.observations.field);
    problem.correlation_length = data.floor.background_length;
    problem.unknown_amplitudes = {0.04e-3, 0.08e-3, 0.16e-3, 0.32e-3};
    problem.unknown_lengths = {1e-3, 2e-3, 4e-3};
    problem.unknown_channels = unknown_channels(data.observations);
    problem.unknown_deviations = {1.0, 4.0};
    problem.shape_correlation = shape_correlation(data.observations, data.floor.background_length);
    return problem;
}

}  // namespace braidzone
