#pragma once

#include "discrepancy/error_model.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace braidzone {

/// How far a simulated and a measured surface are apart [m].
struct GapFigures {
    double rms = 0.0;               ///< of the patches
    double percentile_95 = 0.0;     ///< of the patches' absolute values
    double largest_smoothed = 0.0;  ///< absolute, of the map smoothed over 0.8 mm
};

/// Before and after an effect is in the model, and what noise alone would leave.
struct GapComparison {
    int num_patches = 0;
    GapFigures before, after, floor;
};

/// The gap of each patch after the motion of the scan that the error model makes of the
/// residuals has been taken out [m]: r - G Lambda G' C^-1 r.
/// @param residuals  of all data, patches first [m]
Eigen::VectorXd registered_gap(const ErrorModel& error, const Eigen::VectorXd& residuals);

/// Figures over some patches.
/// @param smoothing  of all patches, see `smoothing_matrix`
GapFigures gap_figures(const Eigen::VectorXd& gap, const Eigen::MatrixXd& smoothing,
                       const std::vector<int>& patches);

/// Before, after and the noise floor over some patches. The floor's figures are medians over
/// residuals drawn from the error model, treated alike.
GapComparison compare_gaps(const ErrorModel& error, const Eigen::MatrixXd& smoothing,
                           const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                           const std::vector<int>& patches, std::uint32_t seed = 1);

}  // namespace braidzone
