#pragma once

#include "export/lattice_files.hpp"
#include "export/lattice_nodes.hpp"
#include "export/node_box.hpp"

#include <filesystem>

namespace braidzone {

/// Writes the lattice as NumPy arrays (format 1.0, little endian), indexed [i, j, k] along x, y, z;
/// in the file x runs fastest (`fortran_order`): cell_type.npy (uint8, `NodeType`), darcy.npy
/// [1/m^2] and forchheimer.npy [1/m] (float32, along the normal), normal.npy (float32, indexed [c,
/// i, j, k]). Held in memory is one plane at a time.
/// @throws IoError if a file cannot be written
std::vector<LatticeFile> write_lattice_arrays(const std::filesystem::path& folder,
                                              const LatticeNodes& nodes);

/// Writes geometry.dat for Palabos (examples/tutorial/permeability): integers in text, x slowest
/// and z fastest, a line for each x and y; 0 in the fluid and at openings, 1 on the wall, 2
/// elsewhere. The tutorial drives flow through the first and last layer, where the openings must
/// be.
/// @param box  the part that is written, see `box_of_used`
/// @throws IoError if the file cannot be written
LatticeFile write_palabos_geometry(const std::filesystem::path& path, const LatticeNodes& nodes,
                                   const NodeBox& box);

/// Writes mask_u8.raw for waLBerla (BinaryRawFile): a byte for each node, x fastest, 1 where there
/// is fluid or an opening, else 0. Its reader skips bytes that are white space, so that no others
/// than 0 and 1 are safe.
/// @throws IoError if the file cannot be written
LatticeFile write_walberla_mask(const std::filesystem::path& path, const LatticeNodes& nodes);

}  // namespace braidzone
