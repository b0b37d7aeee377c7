#pragma once

#include "deploy/deploy_options.hpp"
#include "deploy/flow_diverter.hpp"
#include "deploy/press_geometry.hpp"
#include "deploy/press_reading.hpp"
#include "deploy/wire_network.hpp"

#include <functional>
#include <vector>

namespace braidzone {

/// How a device is pressed, and how finely that is computed.
struct PressOptions {
    PressBench bench;
    double stroke = 5e-3;   ///< way of the head from where it touches the device [m]
    double step = 0.5e-3;   ///< of the head, from one stationary state to the next [m]
    double friction = 0.0;  ///< Coulomb's coefficient of wire on bench [-]

    /// Crossings around the device; 0: those of its wires. A coarser net stands for the same
    /// device, see `press_network`, at a cost that falls with the fourth power.
    int nodes_per_ring = 0;
    /// Bending over surface coefficient of the wires at their crossings [-]; for springs only.
    double bending_ratio = DeployOptions{}.bending_ratio;
    /// Factors on the stiffness of the arms, stretched and bent, and of the radial springs [-]: by
    /// how much a piece is stiffer than its device's figures say.
    double surface_factor = 1.0;
    double radial_factor = 1.0;
    PressReading reading;  ///< how the bench shows displacement and force

    double load_step = 0.125e-3;  ///< longest way of the head at a time [m]
    /// Largest force on a node at rest, over the force of the head [-].
    double residual_tolerance = 1e-3;
    int max_iterations = 200;  ///< in a load step, before it is halved
    int max_halvings = 5;      ///< of a load step, before giving up
};

/// A stationary state of the press test.
struct PressState {
    double displacement = 0.0;  ///< of the head since it touched the device [m]
    double force = 0.0;         ///< of the head on the device, along its motion [N]
    double notch_force = 0.0;   ///< of the block on the device, upwards [N]; equal at rest
    double deflection = 0.0;    ///< way of the hub of the device's middle ring, downwards [m]
    double height = 0.0;        ///< of the middle ring, from its lowest to its highest node [m]
    double energy = 0.0;        ///< elastic, of the device [J]
    double residual = 0.0;      ///< largest force on a node [N]
    int iterations = 0;         ///< since the state before
    std::vector<Vec3> nodes;    ///< |N| x 3 [m]
};

/// A braid to be pressed, and what its forces are to be multiplied with.
struct PressNetwork {
    WireNetwork network;
    double force_scale = 1.0;  ///< from the network's forces to those of the real device [-]
};

/// The network of wires of a device for the press test.
///
/// Forces from springs: arms with the device's surface coefficient, bending `bending_ratio` times
/// that, and its radial springs (`spring_forces.hpp`); times the device's `force_scale` forces are
/// real. Forces from wire theory: the wires' own stiffness against stretching, but no more than
/// 2e4 N/m, beyond which nothing changes, against bending EI / l^3, and the radial springs of
/// `crossing_radial_spring`; forces are real.
///
/// In a net with n' crossings around instead of n a wire stands for n / n' of them, over cells that
/// are n / n' times as large: the stiffness of an arm stays, that of radial springs goes with the
/// node's area, that of bending with (n' / n)^2.
///
/// `surface_factor` and `radial_factor` multiply arms and radial springs of either.
/// @throws ConfigError if the device is not a braid (`validate`)
PressNetwork press_network(const FlowDiverter& device, const PressOptions& options);

/// Presses a braid that lies across a V notch, unheld, by a head at its middle, and gives the
/// stationary states after each step of the head, the first at 0.
///
/// Quasi-static (`network_relaxation.hpp`). At 0 the device has its force-free shape and touches
/// both block and head. Without friction
/// the device is held along x by its middle ring only. Opposite sides of the device do not touch
/// each other.
/// @param on_state  called after each state, e.g. to show progress; may be empty
/// @throws InputError if the device is not longer than the notch is wide, or an option is out of
///         range
/// @throws ConvergenceError if a load step finds no state of rest, with the displacement, or if
///         opposite sides of the device meet
std::vector<PressState> press(const WireNetwork& network, const PressOptions& options,
                              const std::function<void(const PressState&)>& on_state = {});

}  // namespace braidzone
