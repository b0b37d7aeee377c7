#include "export/node_box.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace braidzone {

namespace {

/// The extent of the nodes of each type.
struct TypeExtents {
    struct Extent {
        std::array<int, 3> lowest, highest;
    };
    std::array<Extent, 256> of_type;

    explicit TypeExtents(const LatticeNodes& nodes)
    {
        for (Extent& extent : of_type) {
            extent.lowest.fill(std::numeric_limits<int>::max());
            extent.highest.fill(-1);
        }
        std::size_t index = 0;
        for (int k = 0; k < nodes.grid.dims[2]; ++k) {
            for (int j = 0; j < nodes.grid.dims[1]; ++j) {
                for (int i = 0; i < nodes.grid.dims[0]; ++i, ++index) {
                    Extent& extent = of_type[nodes.type[index]];
                    const std::array<int, 3> place{i, j, k};
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        extent.lowest[axis] = std::min(extent.lowest[axis], place[axis]);
                        extent.highest[axis] = std::max(extent.highest[axis], place[axis]);
                    }
                }
            }
        }
    }
};

}  // namespace

NodeBox box_of_used(const LatticeNodes& nodes)
{
    const TypeExtents extents(nodes);
    NodeBox box;
    box.first = nodes.grid.dims;
    box.last.fill(-1);
    for (std::size_t type = 0; type < extents.of_type.size(); ++type) {
        if (type == static_cast<std::size_t>(NodeType::unused)) continue;
        const auto& [lowest, highest] = extents.of_type[type];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.first[axis] = std::min(box.first[axis], lowest[axis]);
            box.last[axis] = std::max(box.last[axis], highest[axis]);
        }
    }
    return box;
}

OpeningBox box_between_openings(const LatticeNodes& nodes, const Vessel& vessel,
                                LatticeTarget target)
{
    const TargetTraits& traits = traits_of(target);
    const std::string advice = fmt::format(
        "state openings = \"{}\" beside targets, or leave this target out", traits.flat_openings);
    const TypeExtents extents(nodes);
    OpeningBox result;
    for (std::size_t axis = 0; axis < 3; ++axis)
        result.box.last[axis] = nodes.grid.dims[axis] - 1;
    for (const LatticeOpening& entry : nodes.openings) {
        const Opening& opening = vessel.openings[static_cast<std::size_t>(entry.opening)];
        Eigen::Index direction = 0;
        const double along = opening.normal.cwiseAbs().maxCoeff(&direction);
        const auto axis = static_cast<std::size_t>(direction);
        const auto& [lowest, highest] = extents.of_type[entry.code];
        if (lowest[axis] != highest[axis]) {
            throw ConfigError(fmt::format(
                "export.targets: {} wants openings flat on the faces of the box; that at ({:.4g}, "
                "{:.4g}, {:.4g}) mm is turned by {:.2g} degrees from an axis; {}",
                traits.name, 1e3 * opening.centre[0], 1e3 * opening.centre[1],
                1e3 * opening.centre[2], std::acos(std::min(1.0, along)) * 180.0 / std::numbers::pi,
                advice));
        }
        const bool is_upper = opening.normal[direction] > 0.0;
        (is_upper ? result.box.last : result.box.first)[axis] = lowest[axis];
        result.faces.push_back({static_cast<int>(direction), is_upper});
    }
    const auto& [lowest, highest] = extents.of_type[static_cast<std::size_t>(NodeType::fluid)];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (lowest[axis] >= result.box.first[axis] && highest[axis] <= result.box.last[axis])
            continue;
        throw ConfigError(fmt::format(
            "export.targets: {} wants openings on the faces of the box, but along {} fluid reaches "
            "from node {} to {} while the openings are at {} and {}; {}",
            traits.name, "xyz"[axis], lowest[axis], highest[axis], result.box.first[axis],
            result.box.last[axis], advice));
    }
    return result;
}

}  // namespace braidzone
