#pragma once

#include "core/length_unit.hpp"
#include "deploy/braid_lattice.hpp"
#include "deploy/motion_record.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Writes the shapes of a braid on its way to rest as a time series: VTK's collection, such as
/// `frames.pvd`, which ParaView opens as one animated data set with the number of steps as time,
/// and beside it a folder of the same name with the shapes, `frames/frame_0000.vtp`, ...
///
/// Points are the wire crossings in the vessel's length unit, cells the rhombi (quadrilaterals,
/// anticlockwise from outside). Point field: `released` (0/1), 1 for rings out of the catheter.
/// Field data: `length_unit`, `unit:<array>`, and `step`.
///
/// @param collection  its path; ends in .pvd
/// @param frames      |N| nodes of the lattice each [m]
/// @throws IoError if a file cannot be written; InputError if a frame has another number of nodes
void write_frames(const std::filesystem::path& collection, const BraidLattice& lattice,
                  const std::vector<Frame>& frames, const LengthUnit& unit);

}  // namespace braidzone
