#include "discrepancy/device_prediction.hpp"

#include "discrepancy/contact_force.hpp"
#include "porous/braid_surface.hpp"

#include <limits>

namespace braidzone {

DevicePrediction predict(const Model& model, const Simulation& simulation, const Lumen& lumen)
{
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const Deployment& deployment = simulation.deployment;
    const std::optional<Lumen> changed = changed_lumen(model, lumen);
    const BraidMeasures braid = measure(
        make_braid_surface(deployment, simulation.device),
        neck_parts(deployment, find_openings(deployment, changed ? changed->wall : lumen.wall)));
    return {.implanted_length = distal_end(deployment) - proximal_end(deployment),
            .mean_density_increase = braid.mean_density_increase,
            .mean_density_increase_neck = braid.mean_density_increase_neck,
            .contact_force = contact_force(deployment, -everywhere, everywhere)};
}

}  // namespace braidzone
