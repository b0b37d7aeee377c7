#pragma once

#include "discrepancy/density_field.hpp"
#include "discrepancy/discrepancy_field.hpp"
#include "discrepancy/measured_scalars.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// All data of a diagnosis: the measured points in patches, then what else was measured.
struct Observations {
    std::vector<Vec3> points;  ///< in the frame of the scan [m]
    DiscrepancyField field;
    MeasuredScalars scalars;
    DensityField density = {};
};

/// Where the residuals of each channel begin, and how many it has: in this order, those that were
/// not measured left out.
struct ResidualRows {
    Eigen::Index num_patches = 0;
    Eigen::Index lengths = 0, num_lengths = 0;  ///< the measured ones of `MeasuredScalars::values`
    Eigen::Index density = 0, num_density = 0;
    Eigen::Index force = 0, num_force = 0;
    Eigen::Index size = 0;  ///< of all
};
ResidualRows residual_rows(const Observations& observations);

/// Patches, lengths, densities and force that were measured.
Eigen::Index num_residuals(const Observations& observations);

/// Measured minus simulated: gaps of the patches and lengths [m], densities in the unit of their
/// quantity, force [N].
/// @param base  device of the base model, see `patch_gaps`
Eigen::VectorXd residuals(const Observations& observations, const Simulation& simulation,
                          const Imaging& imaging, const DeviceSurface& base);

}  // namespace braidzone
