#include "discrepancy/observations.hpp"

#include <array>

namespace braidzone {

Eigen::Index num_residuals(const Observations& observations)
{
    auto count = static_cast<Eigen::Index>(observations.field.patches.size());
    for (const auto& value : observations.scalars.values)
        count += value ? 1 : 0;
    return count;
}

Eigen::VectorXd residuals(const Observations& observations, const Simulation& simulation,
                          const Imaging& imaging, const DeviceSurface& base)
{
    const Eigen::VectorXd medians =
        patch_medians(observations.points, observations.field, imaging, simulation.surface, base);
    Eigen::VectorXd all(num_residuals(observations));
    all.head(medians.size()) = medians;
    const double distal = distal_end(simulation.deployment);
    const double proximal = proximal_end(simulation.deployment);
    const std::array<double, 3> simulated = {distal, proximal, distal - proximal};
    Eigen::Index row = medians.size();
    for (std::size_t i = 0; i < simulated.size(); ++i) {
        if (observations.scalars.values[i])
            all[row++] = observations.scalars.values[i]->value - simulated[i];
    }
    return all;
}

}  // namespace braidzone
