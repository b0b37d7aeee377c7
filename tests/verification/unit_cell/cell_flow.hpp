#pragma once

#include "support/lattice_boltzmann.hpp"
#include "support/steady_flow.hpp"
#include "verification/unit_cell/braid_cell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace braidzone::test {

/// Slow flow is linear, and steady states do not depend on the viscosity in lattice units: one
/// that converges fast.
constexpr double slow_viscosity_lu = 1.0;
constexpr double slow_velocity_lu = 0.01;

/// Windows in which momentum diffuses over a third of the wires' spacing and sound crosses the box:
/// the slowest changes in the flow.
inline SteadyOptions steady_options(const BraidCell& cell, double viscosity_lu)
{
    const double diffusion = cell.spacing * cell.spacing / (10.0 * viscosity_lu);
    const double sound = std::numbers::sqrt3 * cell.box.dims[2];
    return {.relative_change = 1e-4,
            .window_steps = static_cast<int>(std::max(diffusion, sound)),
            .most_steps = 200000};
}

/// Loss of flow through a braid cell, made dimensionless with the wires' spacing: dp p / (mu v).
/// @param force  g that drives the superficial velocity v
inline double loss(const BraidCell& cell, double force, double viscosity_lu, double velocity_lu)
{
    return force * cell.box.dims[2] * cell.spacing / (viscosity_lu * velocity_lu);
}

/// The force that drives a flow through or along a cell, see `drive_to_flux`.
/// @throws std::runtime_error if the flow does not become steady
inline double steady_force(const BraidCell& cell, LatticeFlow& flow, const Vec3& direction,
                           double velocity_lu)
{
    const SteadyFlow steady =
        drive_to_flux(flow, direction, velocity_lu, steady_options(cell, flow.fluid.viscosity_lu));
    if (!steady.converged) {
        throw std::runtime_error("flow at a braid is not steady after " +
                                 std::to_string(steady.num_steps) + " steps");
    }
    return steady.body_force;
}

inline LatticeFlow flow_through(const BraidCell& cell)
{
    return LatticeFlow(cell.box, {.viscosity_lu = slow_viscosity_lu}, cell.wires);
}

/// p A / mu of slow flow through a braid, A the pressure drop over the superficial velocity.
inline double slow_loss(const BraidCell& cell)
{
    LatticeFlow flow = flow_through(cell);
    const double force = steady_force(cell, flow, Vec3::UnitZ(), slow_velocity_lu);
    return loss(cell, force, slow_viscosity_lu, slow_velocity_lu);
}

/// dp p / (mu v) at rising Reynolds numbers v d / nu, each from the flow before. The first entry is
/// that of slow flow.
/// @param viscosity_lu  the smaller, the slower the flow on the lattice: errors are of the order
///        of its velocity over that of sound, squared
inline std::vector<double> losses_with_inertia(const BraidCell& cell,
                                               const std::vector<double>& reynolds_numbers,
                                               double viscosity_lu)
{
    LatticeFlow flow = flow_through(cell);
    const double slow_force = steady_force(cell, flow, Vec3::UnitZ(), slow_velocity_lu);
    std::vector<double> losses{loss(cell, slow_force, slow_viscosity_lu, slow_velocity_lu)};
    flow.fluid = {.viscosity_lu = viscosity_lu, .inertia = true};
    flow.body_force *= viscosity_lu / slow_viscosity_lu;
    for (const double reynolds : reynolds_numbers) {
        const double velocity = reynolds * viscosity_lu / cell.wire_diameter;
        const double force = steady_force(cell, flow, Vec3::UnitZ(), velocity);
        losses.push_back(loss(cell, force, viscosity_lu, velocity));
    }
    return losses;
}

/// Where the velocity of shear flow along a braid vanishes when extrapolated to it, as slip lengths
/// b = U / (dU/dz) at the mid-plane, on either side [over the wire diameter]. Negative: outside the
/// mid-plane.
struct SlipLengths {
    double above = 0.0;
    double below = 0.0;
};

inline double mean(const SlipLengths& slip)
{
    return 0.5 * (slip.above + slip.below);
}

/// Drives slow shear flow on both sides of a braid by a force on some planes half-way to its
/// images. Between these and the wires the mean velocity of a plane is linear in z.
/// @param direction  in the braid's plane, unit
inline SlipLengths slip_lengths(const BraidCell& cell, const Vec3& direction)
{
    LatticeFlow flow = flow_through(cell);
    const int height = cell.box.dims[2];
    // The braid lies in the middle of the box, so the planes half-way are its first and last.
    flow.forced_planes = {0, 2};
    steady_force(cell, flow, direction, slow_velocity_lu);

    const auto slip = [&](int first, int last) {
        const double from = flow.plane_velocity(first).dot(direction);
        const double shear = (flow.plane_velocity(last).dot(direction) - from) / (last - first);
        return (from / shear - (first - cell.mid_plane)) / cell.wire_diameter;
    };
    const double clear = cell.wire_diameter + 2.0;
    return {slip(static_cast<int>(std::ceil(cell.mid_plane + clear)), height - 2),
            -slip(static_cast<int>(std::floor(cell.mid_plane - clear)), 4)};
}

}  // namespace braidzone::test
