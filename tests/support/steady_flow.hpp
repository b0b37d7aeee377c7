#pragma once

#include "support/lattice_boltzmann.hpp"

#include <cmath>

namespace braidzone::test {

/// When a flow counts as steady, and how long to wait for it.
struct SteadyOptions {
    /// Between the means of the body force over two windows in succession; the velocity is as near
    /// to the wanted one.
    double relative_change = 1e-4;
    int window_steps = 500;
    int most_steps = 100000;
};

/// A steady flow with a given superficial velocity, and the force that drives it.
struct SteadyFlow {
    double body_force = 0.0;  ///< g along the flow, per mass [lattice units]
    int num_steps = 0;
    bool converged = false;
};

/// Drives a flow along `direction` until the superficial velocity along it is `velocity` and the
/// force that this takes no longer changes.
///
/// Every few steps the force becomes the drag, which is the force less the rise of momentum, plus
/// what brings the velocity back within some steps. The steady state is that of the constant force;
/// means over a window are free of the round-off that the control amplifies.
/// @param direction  unit
/// @param velocity   superficial, along the direction [lattice units]
inline SteadyFlow drive_to_flux(LatticeFlow& flow, const Vec3& direction, double velocity,
                                const SteadyOptions& options = {})
{
    constexpr int control_steps = 10, return_steps = 50;
    const double forced_fraction = flow.forced_fraction();
    double force = flow.body_force.dot(direction);
    double last_velocity = flow.superficial_velocity().dot(direction);
    SteadyFlow result;
    while (result.num_steps < options.most_steps && !result.converged) {
        const double last_mean = result.body_force;
        double sum = 0.0;
        int num_forces = 0;
        for (int step = 0; step < options.window_steps; step += control_steps) {
            for (int i = 0; i < control_steps; ++i)
                flow.step();
            const double now = flow.superficial_velocity().dot(direction);
            const double rise = (now - last_velocity) / control_steps;
            const double wanted_rise = (velocity - now) / return_steps;
            sum += force;
            ++num_forces;
            force += (wanted_rise - rise) / forced_fraction;
            flow.body_force = force * direction;
            last_velocity = now;
        }
        result.num_steps += num_forces * control_steps;
        result.body_force = sum / num_forces;
        result.converged =
            std::abs(result.body_force - last_mean) <=
                options.relative_change * std::abs(result.body_force) &&
            std::abs(last_velocity - velocity) <= options.relative_change * std::abs(velocity);
    }
    return result;
}

}  // namespace braidzone::test
