#pragma once

#include "core/vessel.hpp"
#include "export/lattice_nodes.hpp"
#include "export/lattice_targets.hpp"

#include <array>
#include <vector>

namespace braidzone {

/// A part of a lattice: from the first node to the last one along each axis.
struct NodeBox {
    std::array<int, 3> first{}, last{};

    std::array<int, 3> dims() const
    {
        return {last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1};
    }
};

/// A face of a box.
struct BoxFace {
    int axis = 0;           ///< 0 to 2
    bool is_upper = false;  ///< at the last node

    bool operator==(const BoxFace&) const = default;
};

/// A box whose faces the openings of a lattice lie on.
struct OpeningBox {
    NodeBox box;
    std::vector<BoxFace> faces;  ///< of each of the lattice's openings
};

/// The smallest box with all nodes that are not unused. Openings that lie flat across an axis at
/// its ends are its first and last layer there.
NodeBox box_of_used(const LatticeNodes& nodes);

/// The part of a lattice between its openings.
/// @param target  that wants it, for messages
/// @throws ConfigError if an opening's nodes are not one layer across an axis, with the angle that
///         it is turned by, or fluid lies beyond an opening
OpeningBox box_between_openings(const LatticeNodes& nodes, const Vessel& vessel,
                                LatticeTarget target);

}  // namespace braidzone
