#pragma once

#include "discrepancy/error_model.hpp"

#include <Eigen/Core>

namespace braidzone {

/// Above this the noise floor does not fit the data, and what a diagnosis says is not to be
/// trusted: at 1.5 times the background a prototype raised 8 to 11 % false alarms, at twice 35 to
/// 48 %.
constexpr double largest_background_scale = 1.4;

/// Factor on the background's standard deviation at which residuals are most probable, with a
/// log-normal prior of factor 1.6 about 1. A warning light: see `largest_background_scale`.
/// @param residuals  of the best model [m]
double background_scale(const ErrorModel& error, const Eigen::VectorXd& residuals);

}  // namespace braidzone
