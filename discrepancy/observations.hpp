#pragma once

#include "discrepancy/discrepancy_field.hpp"
#include "discrepancy/measured_scalars.hpp"

#include <Eigen/Core>

#include <vector>

namespace braidzone {

/// All data of a diagnosis: the measured points in patches, then the measured scalars.
struct Observations {
    std::vector<Vec3> points;  ///< in the frame of the scan [m]
    DiscrepancyField field;
    MeasuredScalars scalars;
};

/// Patches, then the scalars that were measured.
Eigen::Index num_residuals(const Observations& observations);

/// Measured minus simulated [m]: medians of the patches, then the scalars that were measured.
/// @param base  device of the base model, see `patch_medians`
Eigen::VectorXd residuals(const Observations& observations, const Simulation& simulation,
                          const Imaging& imaging, const DeviceSurface& base);

}  // namespace braidzone
