#pragma once

#include "export/lattice_files.hpp"
#include "export/lattice_nodes.hpp"
#include "export/lattice_units.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// Writes what OpenLB reads (read in its sources, version 1.9):
///
/// case.vti, for a driver that uses `BlockVTIreader3D`: point data in text, one value a node,
/// arrays flags (`NodeType`), darcy_d [1/m^2], forchheimer_f [1/m]; spacing in metres, origin 0
/// (its reader knows neither binary data nor an origin).
///
/// olb_porosity.vdb, for its own `AnalyticalPorosityVolumeF`: one float grid, index (0, 0, 0) the
/// first node, active on the device's nodes only, with the value
///
///     d = 1 - tau a / (1 + a / 2),   a = nu D dt
///
/// for `PorousBGKdynamics`, which holds for the units it is made for and has the linear part only.
/// With 1 - tau a, as OpenLB's example has it, the resistance would be too large by 1 / (1 - a /
/// 2). d falls with a to 0 at a = 1 / (3 nu_lu), the most that this form can express.
///
/// Measured with OpenLB 701968ae (1.9) and its own functor on an exported sheet of 490 Pa s/m in
/// plug flow: 9.817 Pa at 0.02 m/s and 49.02 Pa at 0.1 m/s, where a v is 9.800 and 49.00 Pa.
///
/// @throws ConfigError if the device's resistance is beyond that; IoError if a file cannot be
/// written
std::vector<LatticeFile> write_openlb(const std::filesystem::path& folder,
                                      const LatticeNodes& nodes, const Fluid& fluid,
                                      const LatticeUnits& units);

}  // namespace braidzone
