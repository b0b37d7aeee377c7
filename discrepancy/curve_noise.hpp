#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace braidzone {

/// How far a measured curve and its simulation differ where no effect is missing.
struct CurveNoise {
    double point_sd = 0.0;     ///< of each point, over the simulated value [-]
    double absolute_sd = 0.0;  ///< of each point besides: the sensor's own noise [N or Pa]
    double scale_sd = 0.0;     ///< of a factor common to all points: calibration of the sensor [-]
    double zero_sd = 0.0;      ///< of an offset common to all points [N or Pa]
    /// Error of the model, over the simulated value, and the distance over which its correlation
    /// falls to 1/e, over the range of the abscissae [-].
    double background_sd = 0.0;
    double background_length = 0.0;
    /// Error along the abscissa, as alike from point to point as the background [m or m/s]: where a
    /// head meets the crossings of a braid is known no better than they lie.
    double abscissa_sd = 0.0;
    std::string source = {};  ///< where the constants come from
};

/// Of a press test's force [N]. 1 % of a point; 2 % that changes along the curve, of the device's
/// imperfections; 2 % in common, of the load cell's calibration. What benches of sizes that are off
/// by 0.03 mm, and nets of 12 to 20 crossings around in place of 24, do to the curve is that of an
/// error of 0.018 mm along the displacement, alike over 0.6 mm (fitted to 15 press tests): up to a
/// tenth of the force at the first contact, where few crossings touch, 1 % in the middle.
CurveNoise force_noise();

/// Of a bench's pressure drop [Pa]. Gauges for some 100 Pa are good to 0.5 % and 0.1 Pa, with a
/// zero that drifts as much. The law's linear part is within 1.4 % of wire-resolved flow but leaves
/// out the weave, up to 5 %: 2 % in common to all points. Its quadratic part is within 12 %, where
/// that is a fifth of the loss 2 % at the end of the curve: 1 % that changes slowly with velocity.
CurveNoise pressure_noise();

/// A measured curve against its simulation: what residuals are divided by, and their covariance.
///
/// Residuals are relative: measured minus simulated, over the simulated value of the case as it is,
/// y, plus a twentieth of its largest, which keeps those near zero from counting too much:
///
///     r_i = (measured_i - simulated_i) / w_i,   w_i = |y_i| + 0.05 max |y|
///
/// An error along the abscissa counts with the slope of y between the neighbouring points.
struct CurveWeights {
    Eigen::VectorXd weights;   ///< w [N or Pa]
    Eigen::VectorXd relative;  ///< y / w
    Eigen::MatrixXd nuisance;  ///< of the common factor and the offset
    /// Of r: nuisance, background and points. A point has the greater of its own error and
    /// `standard_error`.
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd distances;  ///< between the abscissae
};

/// @param abscissae       of the points, increasing
/// @param simulated       y, of the case as it is
/// @param standard_error  of a measured point, from its repeats; 0 if unknown [N or Pa]
/// @throws InputError if the simulated curve is zero everywhere
CurveWeights make_curve_weights(const std::vector<double>& abscissae,
                                const std::vector<double>& simulated, double standard_error,
                                const CurveNoise& noise);

/// Log probability density of relative residuals where no effect is missing, but for a constant.
double log_likelihood(const CurveWeights& weights, const Eigen::VectorXd& residuals);

}  // namespace braidzone
