#include "export/foam_sac.hpp"

#include "export/foam_cell_search.hpp"

#include <algorithm>
#include <numeric>

namespace braidzone {

namespace {

struct Part {
    double volume = 0.0;   ///< [m^3]
    bool is_open = false;  ///< touches an inlet or outlet
};

constexpr int not_visited = -1;
constexpr int resistant = -2;

}  // namespace

std::vector<std::vector<int>> find_sacs(const CellResistance& resistance, const FoamMesh& mesh)
{
    if (resistance.cells.empty()) return {};
    const auto neighbours = cell_neighbours(mesh);
    std::vector<char> at_opening(mesh.cell_volumes.size(), 0);
    for (const FoamPatch& patch : mesh.patches) {
        if (patch.type != "patch") continue;
        for (int face = patch.start_face; face < patch.start_face + patch.num_faces; ++face)
            at_opening[static_cast<std::size_t>(mesh.owner[static_cast<std::size_t>(face)])] = 1;
    }

    std::vector<int> part_of(mesh.cell_volumes.size(), not_visited);
    for (const int cell : resistance.cells)
        part_of[static_cast<std::size_t>(cell)] = resistant;
    std::vector<Part> parts;
    for (int seed = 0; seed < mesh.num_cells(); ++seed) {
        if (part_of[static_cast<std::size_t>(seed)] != not_visited) continue;
        const int part = static_cast<int>(parts.size());
        parts.emplace_back();
        std::vector<int> to_visit{seed};
        part_of[static_cast<std::size_t>(seed)] = part;
        while (!to_visit.empty()) {
            const auto cell = static_cast<std::size_t>(to_visit.back());
            to_visit.pop_back();
            parts.back().volume += mesh.cell_volumes[cell];
            parts.back().is_open |= at_opening[cell] != 0;
            for (const int next : neighbours[cell]) {
                int& label = part_of[static_cast<std::size_t>(next)];
                if (label != not_visited) continue;
                label = part;
                to_visit.push_back(next);
            }
        }
    }

    double resistant_volume = 0.0;
    for (const int cell : resistance.cells)
        resistant_volume += mesh.cell_volumes[static_cast<std::size_t>(cell)];
    std::vector<int> order(parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::erase_if(order, [&](int part) {
        const Part& behind = parts[static_cast<std::size_t>(part)];
        return behind.is_open || behind.volume < 0.25 * resistant_volume;
    });
    std::stable_sort(order.begin(), order.end(), [&](int first, int second) {
        return parts[static_cast<std::size_t>(first)].volume >
               parts[static_cast<std::size_t>(second)].volume;
    });
    std::vector<std::vector<int>> sacs(order.size());
    for (std::size_t cell = 0; cell < part_of.size(); ++cell) {
        const auto found = std::find(order.begin(), order.end(), part_of[cell]);
        if (found != order.end())
            sacs[static_cast<std::size_t>(found - order.begin())].push_back(static_cast<int>(cell));
    }
    return sacs;
}

}  // namespace braidzone
