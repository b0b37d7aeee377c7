#pragma once

#include "discrepancy/lumen.hpp"
#include "discrepancy/observations.hpp"

namespace braidzone {

/// Sets `Patch::hub_slope` of all patches: by what the gaps fall when the hubs of the rings lie
/// further towards their open side,
///
///     h = (gap(s) - gap(s + ds)) / ds,   ds = 0.02 mm
///
/// with s `DeployOptions::hub_shift` of the base model. It takes one deployment. Where the wall
/// holds a device all around h is 0. It stays 0 for rings that find their own place (hoop
/// migration, free axial motion), for which there is no such shift.
/// @param model  the base model
/// @param base   its simulation
/// @throws what `simulate` throws
void set_hub_slopes(Observations& observations, const Model& model, const Simulation& base,
                    const Lumen& lumen);

}  // namespace braidzone
