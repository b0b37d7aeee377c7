#pragma once

#include "discrepancy/diagnosis_problem.hpp"
#include "discrepancy/effect.hpp"
#include "discrepancy/error_model.hpp"
#include "discrepancy/observations.hpp"

#include <vector>

namespace braidzone {

/// What a surface diagnosis is made from. All of it must outlive the problem.
struct SurfaceData {
    const Lumen& lumen;
    const EffectSetting& setting;
    const Simulation& base;
    const Observations& observations;
    const ErrorModel& error;
    const NoiseFloor& floor;
};

/// The model with effects in it, one after the other.
/// @throws ConfigError if they cannot stand beside each other or what is there
Model model_with(const std::vector<Effect>& catalogue, const EffectSetting& setting,
                 const std::vector<ActiveEffect>& effects);

/// A measured device surface as the search for a missing effect sees it: residuals are gaps of
/// patches [m], then end positions and length [m], densities and the force on the wall [N], with
/// the scan's registration where it is most probable (`registered_residuals.hpp`); an effect is
/// tried by deploying the device anew.
///
/// The unknown effect is a smooth gap over the device of 0.04, 0.08, 0.16 or 0.32 mm and 1, 2 or
/// 4 mm; ends and length may be off by 1 or 4 mm, densities by 10 or 40 %, the force by 20 or 80 %.
DiagnosisProblem surface_problem(const SurfaceData& data, const std::vector<Effect>& catalogue);

}  // namespace braidzone
