#pragma once

#include <limits>

namespace braidzone {

/// The springs' lattice: the wires' real crossings, or the coarse one of Zavodszky et al. 2020.
enum class LatticeKind { crossings, paper_2020 };

/// Whether rings stay in the planes in which they were released, or move along the vessel.
enum class AxialMotion { locked, free };

/// Ring by ring from the distal end, or all rings together.
enum class ReleaseOrder { ring_by_ring, at_once };

/// Damped motion with inertia, or without ("quasi-static approximation" of the paper); or none: the
/// shape at rest is solved for (`resting_shape.hpp`).
enum class Motion { inertial, quasi_static, none };

/// No sliding at all: the friction of Zavodszky et al. 2020.
constexpr double infinite_friction = std::numeric_limits<double>::infinity();

/// A wall that does not give way: that of Zavodszky et al. 2020.
constexpr double rigid_wall = std::numeric_limits<double>::infinity();

struct DeployOptions {
    LatticeKind lattice = LatticeKind::crossings;
    AxialMotion axial = AxialMotion::locked;
    ReleaseOrder release_order = ReleaseOrder::ring_by_ring;
    Motion motion = Motion::inertial;
    /// h, of the hub to which the radial springs of a ring are fixed: 0 stays in the middle of the
    /// lumen or on the centerline (`centre_rings`), 1 finds its own place in the ring's plane, and
    /// between them a spring ties it to its place (`opening_braid.hpp`).
    double hub_freedom = 0.0;
    /// Shift of the hub of the ring that is open widest towards its open side [m], of others by
    /// their share (`hub_shift.hpp`).
    double hub_shift = 0.0;
    /// Nodes move around their ring where no wall holds them.
    bool hoop_migration = false;
    /// Coulomb's coefficient between wire and wall [-]: 0 for none, or infinite. It matters only
    /// where nodes can slide: with axial freedom or hoop migration.
    double friction = infinite_friction;
    /// Pressure on the wall over its outward displacement [Pa/m]; or rigid.
    double wall_stiffness = rigid_wall;
    /// Rings shift in their plane to the middle of the lumen, see `ring_centring.hpp`;
    /// otherwise their hubs stay on the centerline, as in the paper.
    bool centre_rings = true;
    /// Time step over the stability limit 2 / omega_max of the stiffest lattice mode.
    double time_step_ratio = 0.6;
    /// Damping k [kg/s] at unit mass. The paper takes 0.03 on its coarser lattice; the shape at
    /// rest does not depend on it.
    double damping = 0.2;
    /// Bending over surface coefficient of the wires, see `wire_bending.hpp`. Below 0.1 a device
    /// much narrower than nominal may fold; from 0.1 to 1 the mean radius in a tortuous vessel
    /// changes by 0.2 %, the contact area by 6 %.
    double bending_ratio = 0.25;
    /// Steps between the release of one ring and the next.
    int release_interval = 5;
    /// Convergence: largest force on a free node, over the stiffness of a radial spring times R0.
    double residual_tolerance = 1e-4;
    /// Steps after the last release before giving up.
    int max_settling_steps = 50000;
    /// Shapes to record on the way, at equal numbers of steps, see `Deployment::frames`.
    int num_frames = 0;
};

}  // namespace braidzone
