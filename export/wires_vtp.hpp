#pragma once

#include "core/length_unit.hpp"
#include "deploy/deployment.hpp"

#include <filesystem>

namespace braidzone {

/// Writes `wires.vtp`: every wire as a polyline through its crossings, in the vessel's length unit,
/// mapped through the surface coordinates of the force-free device (Zavodszky et al. 2020,
/// section 2: "the geometry description of the real FD can be attached to these coordinates").
///
/// Between two crossings a wire follows a Catmull-Rom spline through them. Point fields: radius (of
/// the wire, in the file's length unit, for ParaView's tube filter), surface_coordinates (2) [m];
/// cell fields: wire (0 ... wires - 1), family (0 right-handed, 1 left-handed).
/// @throws IoError if the file cannot be written
void write_wires(const std::filesystem::path& path, const Deployment& deployment,
                 double wire_diameter, const LengthUnit& unit);

}  // namespace braidzone
