#include "discrepancy/hub_slopes.hpp"

namespace braidzone {
namespace {

/// About what the hubs scatter by. A device that is but little too wide for its vessel lifts off
/// the wall behind when its hubs move by more [m].
constexpr double step = 0.02e-3;

}  // namespace

void set_hub_slopes(Observations& observations, const Model& model, const Simulation& base,
                    const Lumen& lumen)
{
    if (model.options.hoop_migration || model.options.axial == AxialMotion::free) return;
    Model shifted = model;
    shifted.options.hub_shift += step;
    const auto gaps = [&](const Simulation& simulation) {
        return patch_gaps(observations.points, observations.field, model.imaging,
                          simulation.surface, base.surface);
    };
    const Eigen::VectorXd slopes = (gaps(base) - gaps(simulate(shifted, lumen))) / step;
    for (Eigen::Index i = 0; i < slopes.size(); ++i)
        observations.field.patches[static_cast<std::size_t>(i)].hub_slope = slopes[i];
}

}  // namespace braidzone
