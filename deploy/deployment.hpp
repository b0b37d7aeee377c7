#pragma once

#include "core/centerline.hpp"
#include "core/vessel.hpp"
#include "core/wall_tree.hpp"
#include "deploy/braid_lattice.hpp"
#include "deploy/deploy_options.hpp"
#include "deploy/flow_diverter.hpp"
#include "deploy/motion_record.hpp"
#include "deploy/release_schedule.hpp"

#include <vector>

namespace braidzone {

/// A device as it lies in the vessel. Node arrays have one entry a node of the lattice.
struct Deployment {
    BraidLattice lattice;
    std::vector<Vec3> nodes;  ///< |N| x 3 [m]
    /// 1 where the wire touches the wall: its middle, the node, is no further than its radius.
    std::vector<char> in_contact;
    std::vector<double> wall_distance;  ///< to the wall [m], not negative
    /// With which a node in contact presses on the wall [N]: the radial force of its springs. The
    /// bending of the wires is left out: it moves load from one node to the next, within a few
    /// micrometres of unevenness of the wall, and adds up to nothing.
    std::vector<double> contact_force;
    std::vector<double> contact_pressure;  ///< contact force over the node's deployed area [Pa]
    std::vector<CrossSection> rings;       ///< plane of each ring; tangent points downstream
    std::vector<double> ring_arc_length;   ///< of each ring on the centerline [m]
    double max_force_residual = 0.0;       ///< largest force on a node that is free to move [N]
    double force_tolerance = 0.0;          ///< the criterion that it is compared with [N]
    bool converged = false;
    int steps = 0;
    /// Outward displacement of a compliant wall at each node [m], along the node's ray; 0 where the
    /// wall is rigid or not touched. `wall_distance` is that to the displaced wall.
    std::vector<double> wall_displacement;
    /// Shapes on the way, the last one at rest: `DeployOptions::num_frames` of them, or one for
    /// each step if there are fewer steps.
    std::vector<Frame> frames;
    std::vector<ResidualSample> residual_history;  ///< every few steps, real forces
};

/// Deploys a flow diverter in a vessel (Zavodszky et al. 2020, section 2).
///
/// The lattice is crimped to the catheter's radius along the centerline and released ring by ring
/// from the distal end. Released nodes move in the plane of their ring, along their rays, under the
/// lattice's springs (`spring_forces.hpp`) and the wires' bending (`wire_bending.hpp`) by damped
/// Verlet steps (`equation_of_motion.hpp`), and stop where they meet the wall
/// (`wall_contact.hpp`). It ends when no free node bears a force above the tolerance; otherwise
/// `converged` is false.
///
/// A vessel or an operator that does otherwise than the paper's: the ring spacing, a twist and ends
/// that do not open in full are in `ReleaseSchedule`, the wall and the hubs in `DeployOptions`.
///
/// Nodes keep their angle and rings their plane, as in the surfaces of the paper's authors: a node
/// drifts out of its ray by a few hundredths of a millimetre there. Neither elongation nor
/// migration around the ring is covered.
///
/// @param landing_distal  arc length of the distal end on the centerline [m]
/// @throws GeometryError if the device does not lie within the centerline, the catheter does not
///         fit into the lumen, the device is too small or too large for the vessel, or so large
///         that it buckles and nodes pass the hubs of their rings; ConfigError
///         if the schedule is not valid, or an option does not go together with the others
Deployment deploy(const FlowDiverter& device, const Centerline& centerline, const WallTree& wall,
                  double landing_distal, const ReleaseSchedule& schedule,
                  const DeployOptions& options = {});

}  // namespace braidzone
