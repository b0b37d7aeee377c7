#pragma once

#include "deploy/press_test.hpp"

#include <functional>
#include <vector>

namespace braidzone {

/// A device under a press test.
struct PressModel {
    FlowDiverter device;
    PressOptions options;
};

/// The force curve of a press test as a function of what may be wrong in it, at the cost of a
/// table: after ten press tests (`make_press_response`) any model takes microseconds.
///
///     F(x) = S F_0(x) R(ratio, x) M(friction, x)
///
/// S is the common factor: forces are proportional to the stiffness of all springs together, so
/// that only the ratio of the radial ones to the arms changes the curve's shape. F_0 is the press
/// test of the case as it is, on its own net. R and M are the changes with the ratio and with the
/// friction, over the same of the case as it is, on a coarser net: that gets forces wrong by as
/// much before and after. ln R is interpolated in the logarithm of the ratio. Friction acts at a
/// handful of nodes, which stick and slip one by one, so that ln M is taken as proportional to it,
/// with a parabola of x for the factor, fitted to several coefficients; what is left of ln M is
/// the scatter of sticking and slipping, which no table foretells: it is alike for all
/// coefficients, per coefficient, on nets of 10 to 24 crossings around.
///
/// A wire's diameter d counts with d^4 where forces come from wire theory, as bending and torsion
/// do; wires are as good as inextensible.
struct PressResponse {
    PressModel base;
    double force_scale = 1.0;                ///< from F_0 to the real device [-]
    double step = 0.0;                       ///< between states [m]
    std::vector<double> force;               ///< F_0 at 0, step, 2 step, ... [N]
    std::vector<std::vector<double>> ratio;  ///< ln R at each of `press_log_ratios`, alike
    std::vector<double> friction;            ///< d ln M / d friction at the same places
    double slip = 0.0;  ///< standard deviation of ln M about that, over the change of friction
};

/// Logarithms of the ratio of radial springs to arms, over that of the case as it is: even steps.
std::vector<double> press_log_ratios();

struct PressResponseOptions {
    /// Crossings around on the net for changes; the case's own net if that is coarser.
    int coarse_nodes_per_ring = 10;
    bool with_changes = true;  ///< false: the case as it is alone, one press test
    /// Told how many of the press tests are done.
    std::function<void(int done, int all)> on_progress = {};
};

/// Runs the press tests, in parallel, up to a displacement and a little more, as far as the device
/// allows. One with another ratio or friction that finds no state of rest counts as far as it came.
/// @param stroke  largest measured displacement [m]
/// @throws ConvergenceError if the case as it is does not reach it; else what `press` throws
PressResponse make_press_response(const PressModel& base, double stroke,
                                  const PressResponseOptions& options = {});

/// Forces that the bench shows at displacements (`PressReading`) [N]; 0 before the head touches.
/// @throws InputError if the model's ratio is beyond what was tabulated, or its friction is
/// negative
std::vector<double> press_forces(const PressResponse& response, const PressModel& model,
                                 const std::vector<double>& displacements);

}  // namespace braidzone
