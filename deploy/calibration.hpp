#pragma once

#include "deploy/flow_diverter.hpp"
#include "deploy/force_curve.hpp"
#include "deploy/press_test.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// A coefficient as a fit determines it.
struct Estimate {
    double value = 0.0;                 ///< [N/m]
    double relative_error = 0.0;        ///< standard error of its logarithm, from the noise [-]
    double discretisation_error = 0.0;  ///< of its logarithm, from the net's fineness [-]
    double lower = 0.0;                 ///< of the 95 % interval [N/m]
    double upper = 0.0;
};

/// Spring coefficients fitted to a measured press test, as real forces (force scale 1).
struct Calibration {
    Estimate surface;  ///< c_surface
    Estimate radial;   ///< c_radial, of a node that stands for the device's `reference_node_area`
    int nodes_per_ring = 0;            ///< of the net that was fitted
    int coarse_nodes_per_ring = 0;     ///< of the one that tells its discretisation error
    double standard_error = 0.0;       ///< of a point of the curve, as the fit weighs it [N]
    double correlation = 0.0;          ///< of the two logarithms [-], -1 to 1
    double reduced_chi_square = 0.0;   ///< about 1 if the model fits within the noise
    std::vector<double> fitted_force;  ///< at the curve's points [N]
    std::string statement;             ///< what the data determine and what not
};

/// Fits a device's spring coefficients to a measured force curve by nonlinear least squares
/// (Ceres, Levenberg-Marquardt) over log c_surface and log(c_radial / c_surface):
///
///     minimise sum over points of [ (F_measured - c_surface G(c_radial / c_surface, x)) / s ]^2
///
/// G is the simulated press test (`press`); forces without friction are proportional to a common
/// factor of the coefficients, so that only their ratio needs simulations. s is the standard error
/// of the repeats' mean, but no less than a hundredth of the largest force: the model is no better
/// than that.
///
/// The noise makes an error e_n of each logarithm: that of the linearised problem, widened by the
/// root of the reduced chi square where that is above 1. The net's fineness makes another, e_d: the
/// fit is repeated on a net of half as many crossings around (but at least six), and the finer one
/// is taken to be wrong by
///
///     e_d = | log c(n) - log c(n') | / (n / n' - 1)
///
/// as if the error fell with the first power of the width of a cell. The force of the press test
/// falls into place with about the second, but nets of six or eight crossings need not follow that.
///
/// A 95 % interval is log c +- sqrt((t e_n)^2 + e_d^2) with Student's t for the degrees of freedom.
///
/// @param device   its spring coefficients are where the fit begins
/// @param options  the bench and the net (`nodes_per_ring` 0 or at least 8); stroke and step follow
///                 from the curve
/// @throws ConfigError if the net is too coarse; InputError if the device has no spring
///         coefficients or the curve holds no force; ConvergenceError if the press test or the fit
///         does not converge
Calibration calibrate(const FlowDiverter& device, const PressOptions& options,
                      const ForceCurve& measured);

}  // namespace braidzone
