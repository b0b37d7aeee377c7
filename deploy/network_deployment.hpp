#pragma once

#include "deploy/deployment.hpp"
#include "deploy/wire_network.hpp"

namespace braidzone {

/// True if nodes are to leave their rays: with axial freedom or hoop migration.
bool needs_wire_network(const DeployOptions& options);

/// The device as a network of wires with real forces.
///
/// With axial freedom the wires are practically inextensible: an arm has the stiffness EA / l of
/// its wire, but no more than 2e4 N/m, at which the largest forces stretch it by less than a
/// hundredth. Otherwise rings are locked in planes that the wires would leave, and the arms are the
/// surface springs (`spring_coefficients`). Bending stiffness is EI / l^3 of the wire where its
/// modulus is known, else `DeployOptions::bending_ratio` times the surface spring.
WireNetwork wire_network(const FlowDiverter& device, const DeployOptions& options);

/// Deploys a device as a network of wires (`wire_network.hpp`), either free to move along the
/// vessel (`axial_release.hpp`) or with its nodes free in the planes of their rings
/// (`plane_release.hpp`). Motion is quasi-static; the hub of a ring is the mean of its nodes;
/// contact forces are those on the wall, bending included.
///
/// @throws ConfigError for options that do not go together with it; GeometryError as `deploy`
Deployment deploy_wire_network(const FlowDiverter& device, const Centerline& centerline,
                               const WallTree& wall, double landing_distal,
                               const ReleaseSchedule& schedule, const DeployOptions& options);

}  // namespace braidzone
