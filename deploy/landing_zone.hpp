#pragma once

#include "core/centerline.hpp"
#include "core/wall_tree.hpp"
#include "deploy/crimped_braid.hpp"
#include "deploy/flow_diverter.hpp"

#include <vector>

namespace braidzone {

// Whether a device can be deployed where it is to land.

/// @param positions  arc lengths of the rings [m], distal first
/// @throws GeometryError if the rings do not all lie on the centerline
void require_device_on_centerline(const Centerline& centerline,
                                  const std::vector<double>& positions);

/// @throws GeometryError if the crimped braid does not lie within the lumen everywhere
void require_room_for_catheter(const CrimpedBraid& braid, const std::vector<double>& positions,
                               const WallTree& wall);

/// @throws GeometryError if the device is narrower than the vessel everywhere, so that nothing
///         would hold it, or more than twice as wide on average
void require_fitting_diameter(const FlowDiverter& device, const std::vector<CrossSection>& rings);

}  // namespace braidzone
