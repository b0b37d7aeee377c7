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

/// Share of the gap that is gone: (before^2 - after^2) / (before^2 - floor^2) of the RMS. 1 if all
/// that is above the floor is gone; without meaning where nothing was.
double closure(const GapComparison& gaps);

/// Rows that make the gap of each patch out of all residuals, patches first: the motion of the
/// scan that the error model makes of the residuals is taken out, r - G Lambda G' C^-1 r.
Eigen::MatrixXd registration_taken_out(const ErrorModel& error);

/// Figures over some patches.
/// @param smoothing  of all patches, see `smoothing_matrix`
GapFigures gap_figures(const Eigen::VectorXd& gap, const Eigen::MatrixXd& smoothing,
                       const std::vector<int>& patches);

/// Figures where no effect is missing: medians over residuals drawn from the error model.
/// @param taking  rows that make the gap of each patch out of all residuals
GapFigures floor_figures(const Eigen::MatrixXd& taking, const Eigen::MatrixXd& covariance,
                         const Eigen::MatrixXd& smoothing, const std::vector<int>& patches,
                         std::uint32_t seed = 1);

}  // namespace braidzone
