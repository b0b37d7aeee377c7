#pragma once

#include "deploy/neck.hpp"
#include "discrepancy/model.hpp"

#include <optional>

namespace braidzone {

/// What a simulated device is like where its surface alone does not tell.
struct DevicePrediction {
    double implanted_length = 0.0;       ///< [m]
    double mean_density_increase = 0.0;  ///< against the model's own force-free device [-]
    /// Over the neck, the largest opening behind the device [-]; none without one.
    std::optional<double> mean_density_increase_neck;
    double contact_force = 0.0;  ///< on the wall, of the whole device [N]
};

/// @param model       that was simulated
/// @param simulation  of it
/// @param lumen       of the case
DevicePrediction predict(const Model& model, const Simulation& simulation, const Lumen& lumen);

}  // namespace braidzone
