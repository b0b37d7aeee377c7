#pragma once

#include "core/vessel_straightening.hpp"
#include "deploy/deployment.hpp"
#include "discrepancy/device_surface.hpp"
#include "discrepancy/imaging.hpp"
#include "discrepancy/lumen.hpp"

#include <optional>

namespace braidzone {

/// Everything that an effect may change: what the deployment is made from, and how its result was
/// seen.
struct Model {
    FlowDiverter device;
    double landing_distal = 0.0;  ///< arc length of the distal end [m]
    ReleaseSchedule schedule;
    DeployOptions options;
    double wall_offset = 0.0;  ///< by which the vessel's wall lies outside that of the lumen [m]
    VesselStraightening straightening;  ///< of the lumen, after its wall has been moved
    Imaging imaging;
};

/// A device as a model deploys it.
struct Simulation {
    Deployment deployment;
    DeviceSurface surface;  ///< through the imaging chain of the model
    FlowDiverter device = {};
};

/// The lumen as a model changes it; none if it does not.
/// @throws GeometryError if the vessel cannot be changed so far
std::optional<Lumen> changed_lumen(const Model& model, const Lumen& lumen);

/// Deploys the device of a model.
/// @param lumen  of the case; `model.wall_offset` and `model.straightening` come on top
/// @throws ConvergenceError if the device does not come to rest; else what `deploy` throws
Simulation simulate(const Model& model, const Lumen& lumen);

/// Arc lengths of the device's ends [m].
double distal_end(const Deployment& deployment);
double proximal_end(const Deployment& deployment);

}  // namespace braidzone
