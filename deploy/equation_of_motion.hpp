#pragma once

namespace braidzone {

/// One step of the damped position-Verlet scheme for m x'' = F - k x':
///
///     x(t + dt) - x(t) = [ (1 - k dt / 2m) (x(t) - x(t - dt)) + dt^2 / m F ] / (1 + k dt / 2m)
///
/// Second order in dt; stable for dt below 2 / omega. Mass and time are fictitious: they shape the
/// way to equilibrium, not the equilibrium (Zavodszky et al. 2020, equations 1 and 2).
struct VerletScheme {
    double time_step = 0.0;  ///< dt [s]
    double mass = 1.0;       ///< m [kg]
    double damping = 0.0;    ///< k [kg/s]
};

/// Displacement of the next step, of one coordinate [m].
/// @param last_displacement  x(t) - x(t - dt) [m]
/// @param force              F without damping [N]
double next_displacement(const VerletScheme& scheme, double last_displacement, double force);

}  // namespace braidzone
