#include "export/resisting_planes.hpp"

#include <numeric>

namespace braidzone {

ResistingPlanes::ResistingPlanes(const LatticeNodes& nodes, int axis)
    : sorted_(nodes.resisting.size()),
      starts_(static_cast<std::size_t>(nodes.grid.dims[static_cast<std::size_t>(axis)]) + 1, 0)
{
    const auto plane_of = [&](std::int64_t node) {
        return static_cast<std::size_t>(place_of(nodes.grid, node)[static_cast<std::size_t>(axis)]);
    };
    for (const std::int64_t node : nodes.resisting)
        ++starts_[plane_of(node) + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::size_t> next = starts_;
    for (std::size_t i = 0; i < nodes.resisting.size(); ++i)
        sorted_[next[plane_of(nodes.resisting[i])]++] = i;
}

std::span<const std::size_t> ResistingPlanes::in_plane(int plane) const
{
    const std::size_t first = starts_[static_cast<std::size_t>(plane)];
    return {sorted_.data() + first, starts_[static_cast<std::size_t>(plane) + 1] - first};
}

}  // namespace braidzone
