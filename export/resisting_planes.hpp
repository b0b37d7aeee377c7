#pragma once

#include "export/lattice_nodes.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace braidzone {

/// The resisting nodes of a lattice plane by plane, for writers that hold one plane at a time.
class ResistingPlanes {
public:
    /// @param axis  0 to 2, across the planes
    ResistingPlanes(const LatticeNodes& nodes, int axis);

    /// Those in the plane, as places in `LatticeNodes::resisting`, increasing.
    std::span<const std::size_t> in_plane(int plane) const;

private:
    std::vector<std::size_t> sorted_;
    std::vector<std::size_t> starts_;  ///< of each plane in `sorted_`, and the end
};

}  // namespace braidzone
