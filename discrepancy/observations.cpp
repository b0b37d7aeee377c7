#include "discrepancy/observations.hpp"

#include "discrepancy/contact_force.hpp"

#include <array>

namespace braidzone {

ResidualRows residual_rows(const Observations& observations)
{
    ResidualRows rows;
    rows.num_patches = static_cast<Eigen::Index>(observations.field.patches.size());
    rows.lengths = rows.num_patches;
    for (const auto& value : observations.scalars.values)
        rows.num_lengths += value ? 1 : 0;
    rows.density = rows.lengths + rows.num_lengths;
    rows.num_density = static_cast<Eigen::Index>(observations.density.places.size());
    rows.force = rows.density + rows.num_density;
    rows.num_force = observations.scalars.contact_force ? 1 : 0;
    rows.size = rows.force + rows.num_force;
    return rows;
}

Eigen::Index num_residuals(const Observations& observations)
{
    return residual_rows(observations).size;
}

Eigen::VectorXd residuals(const Observations& observations, const Simulation& simulation,
                          const Imaging& imaging, const DeviceSurface& base)
{
    const ResidualRows rows = residual_rows(observations);
    Eigen::VectorXd all(rows.size);
    all.head(rows.num_patches) =
        patch_gaps(observations.points, observations.field, imaging, simulation.surface, base);
    const double distal = distal_end(simulation.deployment);
    const double proximal = proximal_end(simulation.deployment);
    const std::array<double, 3> simulated = {distal, proximal, distal - proximal};
    Eigen::Index row = rows.lengths;
    for (std::size_t i = 0; i < simulated.size(); ++i) {
        if (observations.scalars.values[i])
            all[row++] = observations.scalars.values[i]->value - simulated[i];
    }
    const Eigen::VectorXd density = simulated_density(observations.density, imaging, simulation);
    for (Eigen::Index i = 0; i < rows.num_density; ++i) {
        all[rows.density + i] =
            observations.density.places[static_cast<std::size_t>(i)].value - density[i];
    }
    if (const auto& force = observations.scalars.contact_force) {
        all[rows.force] =
            force->force.value - contact_force(simulation.deployment, force->from, force->to);
    }
    return all;
}

}  // namespace braidzone
