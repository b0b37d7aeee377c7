#include "export/lattice_seal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace braidzone {

namespace {

constexpr auto fluid = static_cast<std::uint8_t>(NodeType::fluid);
constexpr auto inlet = static_cast<std::uint8_t>(NodeType::inlet);

/// Nodes that the flood may not pass: resisting ones, and in the end all that it has reached.
class Flood {
public:
    explicit Flood(const LatticeNodes& nodes) : nodes_(nodes), closed_(nodes.type.size(), false)
    {
        for (const std::int64_t node : nodes.resisting)
            closed_[static_cast<std::size_t>(node)] = true;
        resisting_ = closed_;
    }

    void run()
    {
        std::vector<std::int64_t> front, next;
        for (std::size_t node = 0; node < nodes_.type.size(); ++node)
            if (nodes_.type[node] == inlet) front.push_back(static_cast<std::int64_t>(node));
        while (!front.empty()) {
            next.clear();
            for (const std::int64_t node : front)
                for_each_neighbour(node, [&](std::size_t other) {
                    if (nodes_.type[other] != fluid || closed_[other]) return;
                    closed_[other] = true;
                    next.push_back(static_cast<std::int64_t>(other));
                });
            front.swap(next);
        }
    }

    bool is_free(std::size_t node) const { return nodes_.type[node] == fluid && !resisting_[node]; }
    bool is_reached(std::size_t node) const { return closed_[node]; }

private:
    template <typename Visit>
    void for_each_neighbour(std::int64_t node, Visit visit) const
    {
        const std::array<int, 3> place = place_of(nodes_.grid, node);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                std::array<int, 3> other = place;
                other[axis] += step;
                if (other[axis] < 0 || other[axis] >= nodes_.grid.dims[axis]) continue;
                visit(nodes_.grid.index(other[0], other[1], other[2]));
            }
        }
    }

    const LatticeNodes& nodes_;
    std::vector<bool> closed_, resisting_;
};

NeckSeal seal_of(const LatticeNodes& nodes, const Flood& flood, const NeckProbe& probe)
{
    const double h = nodes.grid.spacing;
    for (double along = 0.0;; along += 0.5 * h) {
        const Vec3 place = (probe.centre + along * probe.outwards - nodes.grid.origin) / h;
        std::array<int, 3> node{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            node[a] = static_cast<int>(std::lround(place[axis]));
            if (node[a] < 0 || node[a] >= nodes.grid.dims[a]) return NeckSeal::absent;
        }
        const std::size_t index = nodes.grid.index(node[0], node[1], node[2]);
        if (nodes.type[index] != fluid) return NeckSeal::absent;
        if (!flood.is_free(index)) continue;
        return flood.is_reached(index) ? NeckSeal::leaks : NeckSeal::sealed;
    }
}

}  // namespace

std::vector<NeckProbe> neck_probes(const Deployment& deployment,
                                   const std::vector<WallOpening>& openings)
{
    std::vector<NeckProbe> probes;
    for (const WallOpening& opening : openings) {
        if (opening.nodes.empty()) continue;
        const auto place = [&](int node) -> const Vec3& {
            return deployment.nodes[static_cast<std::size_t>(node)];
        };
        Vec3 mean = Vec3::Zero();
        for (const int node : opening.nodes)
            mean += place(node) / static_cast<double>(opening.nodes.size());
        // The mean itself lies off the sheet, which is curved.
        const int middle = *std::min_element(
            opening.nodes.begin(), opening.nodes.end(),
            [&](int a, int b) { return (place(a) - mean).norm() < (place(b) - mean).norm(); });
        const auto ring = static_cast<std::size_t>(middle / deployment.lattice.nodes_per_ring);
        probes.push_back(
            {place(middle), (place(middle) - deployment.rings[ring].origin).normalized()});
    }
    return probes;
}

std::string_view name_of(NeckSeal seal)
{
    switch (seal) {
        case NeckSeal::sealed:
            return "sealed";
        case NeckSeal::leaks:
            return "leaks";
        case NeckSeal::absent:
            return "absent";
    }
    return {};
}

LatticeSeal lattice_seal(const LatticeNodes& nodes, const std::vector<NeckProbe>& probes)
{
    Flood flood(nodes);
    flood.run();
    LatticeSeal seal;
    for (std::size_t node = 0; node < nodes.type.size(); ++node)
        seal.num_behind += nodes.type[node] == fluid && !flood.is_reached(node);
    for (const NeckProbe& probe : probes)
        seal.necks.push_back(seal_of(nodes, flood, probe));
    return seal;
}

}  // namespace braidzone
