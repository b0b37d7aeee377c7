#pragma once

#include "core/vessel.hpp"
#include "export/lattice_targets.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// What a lattice takes, predicted before it is made.
struct LatticeCost {
    std::array<double, 3> dims{};  ///< nodes along each axis
    double spacing = 0.0;          ///< [m]
    double memory = 0.0;           ///< at most, beside the vessel and the device [bytes]
    double disk = 0.0;             ///< of all targets together, at most [bytes]

    double num_nodes() const { return dims[0] * dims[1] * dims[2]; }
};

/// Predicts the cost. The writers hold one plane of nodes at a time, so that memory is the node
/// types, the flood behind the device and the wall distances. Measured at 2e7 to 5e8 nodes, for
/// every target, are 1.25 bytes a node and 32 bytes for each piece of the wall of a spacing
/// squared; here with a reserve, 1.3 and 60.
LatticeCost lattice_cost(const Vessel& vessel, double spacing,
                         const std::vector<LatticeTarget>& targets);

/// What there is.
struct LatticeRoom {
    double memory = 0.0;  ///< of the machine [bytes]
    double disk = 0.0;    ///< free, where the files go [bytes]
};

LatticeRoom room_at(const std::filesystem::path& folder);

/// @throws ConfigError if a lattice has more than `most_lattice_nodes` or needs more memory than
///         there is, with the spacing that fits; IoError if it needs more disk
void require_room(const LatticeCost& cost, const LatticeRoom& room);

/// "411 x 203 x 187 = 1.56e+07 nodes, 0.1 GB of memory, 0.5 GB of disk".
std::string describe(const LatticeCost& cost);

}  // namespace braidzone
