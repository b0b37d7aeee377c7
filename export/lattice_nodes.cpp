#include "export/lattice_nodes.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace braidzone {

namespace {

constexpr int margin = 2;
constexpr std::size_t most_openings = 246;

/// The 18 links of D3Q19 to other nodes.
constexpr std::array<std::array<int, 3>, 18> links{{{1, 0, 0},
                                                    {-1, 0, 0},
                                                    {0, 1, 0},
                                                    {0, -1, 0},
                                                    {0, 0, 1},
                                                    {0, 0, -1},
                                                    {1, 1, 0},
                                                    {-1, -1, 0},
                                                    {1, -1, 0},
                                                    {-1, 1, 0},
                                                    {1, 0, 1},
                                                    {-1, 0, -1},
                                                    {1, 0, -1},
                                                    {-1, 0, 1},
                                                    {0, 1, 1},
                                                    {0, -1, -1},
                                                    {0, 1, -1},
                                                    {0, -1, 1}}};

/// The first and the last node over the whole vessel, in spacings: nodes lie on its multiples, as
/// those of every field.
std::pair<Vec3, Vec3> node_range(const Vessel& vessel, double spacing)
{
    const Box box = bounding_box(vessel.wall);
    const Vec3 room = Vec3::Constant(margin);
    return {(box.lower / spacing).array().floor().matrix() - room,
            (box.upper / spacing).array().ceil().matrix() + room};
}

VoxelGrid grid_over(const Vessel& vessel, double spacing)
{
    const Vec3 count = lattice_dims(vessel, spacing);
    if (!(count.prod() <= most_lattice_nodes)) {
        throw ConfigError(fmt::format(
            "grid.spacing = {:.6g} mm gives a lattice of {:.0f} x {:.0f} x {:.0f} = {:.4g} nodes "
            "over the vessel; at most {:.4g} are allowed",
            1e3 * spacing, count[0], count[1], count[2], count.prod(), most_lattice_nodes));
    }
    VoxelGrid grid;
    grid.spacing = spacing;
    grid.origin = spacing * node_range(vessel, spacing).first;
    grid.dims = {static_cast<int>(count[0]), static_cast<int>(count[1]),
                 static_cast<int>(count[2])};
    return grid;
}

bool is_in_grid(const VoxelGrid& grid, const std::array<int, 3>& node)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (node[axis] < 0 || node[axis] >= grid.dims[axis]) return false;
    return true;
}

class Layer {
public:
    Layer(LatticeNodes& nodes, const Vessel& vessel, const VoxelWallDistance& distance)
        : nodes_(nodes), vessel_(vessel), distance_(distance)
    {
    }

    /// Takes the nodes in the plane of a cap out of the fluid: of those, round-off decides which
    /// lie in the lumen, and an opening's layer is to be flat.
    void trim_caps()
    {
        for_each_held_node([&](const std::array<int, 3>& node) {
            if (type(node) != static_cast<std::uint8_t>(NodeType::fluid)) return;
            const Vec3 place = nodes_.grid.centre(node[0], node[1], node[2]);
            for (const Opening& opening : vessel_.openings) {
                const double beyond = (place - opening.centre).dot(opening.normal);
                const Vec3 across = place - opening.centre - beyond * opening.normal;
                if (std::abs(beyond) < round_off() && across.norm() < 2.0 * opening.radius)
                    type(node) = static_cast<std::uint8_t>(NodeType::unused);
            }
        });
    }

    /// Marks what surrounds the fluid.
    void mark_surroundings()
    {
        for_each_held_node([&](const std::array<int, 3>& node) { mark_around(node); });
    }

private:
    double round_off() const { return 1e-6 * nodes_.grid.spacing; }

    /// Calls visit(node) for the nodes of all held cubes: wall and caps lie in them.
    template <typename Visit>
    void for_each_held_node(Visit visit)
    {
        const VoxelCubes& cubes = distance_.cubes;
        constexpr int edge = VoxelCubes::edge;
        for (const std::int32_t cube : cubes.held) {
            const auto& [a, b, c] = cubes.place_of(static_cast<std::size_t>(cube));
            for (int k = edge * c; k < edge * (c + 1); ++k) {
                for (int j = edge * b; j < edge * (b + 1); ++j) {
                    for (int i = edge * a; i < edge * (a + 1); ++i) {
                        const std::array<int, 3> node{i, j, k};
                        if (is_in_grid(nodes_.grid, node)) visit(node);
                    }
                }
            }
        }
    }

    std::uint8_t& type(const std::array<int, 3>& node)
    {
        return nodes_.type[nodes_.grid.index(node[0], node[1], node[2])];
    }

    void mark_around(const std::array<int, 3>& fluid_node)
    {
        constexpr auto fluid = static_cast<std::uint8_t>(NodeType::fluid);
        constexpr auto wall = static_cast<std::uint8_t>(NodeType::wall);
        constexpr auto unused = static_cast<std::uint8_t>(NodeType::unused);
        if (type(fluid_node) != fluid) return;
        for (const auto& link : links) {
            const std::array<int, 3> node{fluid_node[0] + link[0], fluid_node[1] + link[1],
                                          fluid_node[2] + link[2]};
            std::uint8_t& here = type(node);
            if (here != unused && here != wall) continue;
            LatticeOpening* opening = opening_between(fluid_node, node);
            if (opening != nullptr) {
                here = opening->code;
                ++opening->num_nodes;
            } else {
                here = wall;
            }
        }
    }

    /// The opening whose cap lies between a fluid node and one beside it, and has lumen behind the
    /// latter; none if there is no such opening.
    LatticeOpening* opening_between(const std::array<int, 3>& inside,
                                    const std::array<int, 3>& outside)
    {
        const double h = nodes_.grid.spacing;
        const Vec3 from = nodes_.grid.centre(inside[0], inside[1], inside[2]);
        const Vec3 to = nodes_.grid.centre(outside[0], outside[1], outside[2]);
        for (LatticeOpening& entry : nodes_.openings) {
            const Opening& opening = vessel_.openings[static_cast<std::size_t>(entry.opening)];
            const double before = (from - opening.centre).dot(opening.normal);
            const double beyond = (to - opening.centre).dot(opening.normal);
            if (!(before < 0.5 * h && beyond > -round_off())) continue;
            const Vec3 across = to - opening.centre - beyond * opening.normal;
            if (across.norm() > 2.0 * opening.radius) continue;
            const Vec3 behind = to - (beyond + 0.75 * h) * opening.normal;
            const Vec3 place = (behind - nodes_.grid.origin) / h;
            const std::array<int, 3> nearest{static_cast<int>(std::lround(place[0])),
                                             static_cast<int>(std::lround(place[1])),
                                             static_cast<int>(std::lround(place[2]))};
            if (is_in_grid(nodes_.grid, nearest) &&
                type(nearest) == static_cast<std::uint8_t>(NodeType::fluid))
                return &entry;
        }
        return nullptr;
    }

    LatticeNodes& nodes_;
    const Vessel& vessel_;
    const VoxelWallDistance& distance_;
};

/// The inlet first, then the outlets by size.
std::vector<LatticeOpening> list_openings(const Vessel& vessel, int inlet)
{
    if (vessel.openings.size() > most_openings) {
        throw ConfigError(fmt::format("{} openings of the vessel; a lattice takes {} at most",
                                      vessel.openings.size(), most_openings));
    }
    std::vector<LatticeOpening> openings{{inlet, static_cast<std::uint8_t>(NodeType::inlet), 0}};
    auto code = static_cast<std::uint8_t>(NodeType::outlet);
    for (int opening = 0; opening < static_cast<int>(vessel.openings.size()); ++opening) {
        if (opening == inlet) continue;
        openings.push_back({opening, code, 0});
        ++code;
    }
    return openings;
}

/// Takes over the field's resistance, node by node.
void add_resistance(LatticeNodes& nodes, const PorousField& field)
{
    std::array<int, 3> shift{};
    for (int axis = 0; axis < 3; ++axis) {
        const double steps =
            (field.grid.origin[axis] - nodes.grid.origin[axis]) / field.grid.spacing;
        shift[static_cast<std::size_t>(axis)] = static_cast<int>(std::lround(steps));
    }
    std::vector<std::pair<std::int64_t, std::size_t>> touched;
    for (std::size_t i = 0; i < field.voxels.size(); ++i) {
        if (cell_type(field, i) != CellType::porous) continue;
        const std::array<int, 3> place = place_of(field.grid, field.voxels[i]);
        touched.emplace_back(static_cast<std::int64_t>(nodes.grid.index(
                                 place[0] + shift[0], place[1] + shift[1], place[2] + shift[2])),
                             i);
    }
    std::sort(touched.begin(), touched.end());
    for (const auto& [node, i] : touched) {
        nodes.resisting.push_back(node);
        nodes.darcy.push_back(field.darcy_normal[i]);
        nodes.forchheimer.push_back(field.forchheimer_normal[i]);
        nodes.surface_density.push_back(field.surface_density[i]);
        nodes.normal.push_back(field.normal[i]);
    }
}

}  // namespace

Vec3 lattice_dims(const Vessel& vessel, double spacing)
{
    const auto [first, last] = node_range(vessel, spacing);
    return last - first + Vec3::Ones();
}

LatticeNodes make_lattice_nodes(const PorousField& field, const Vessel& vessel, int inlet)
{
    LatticeNodes nodes;
    nodes.grid = grid_over(vessel, field.grid.spacing);
    nodes.tangential_ratio = field.tangential_ratio;
    nodes.openings = list_openings(vessel, inlet);
    const VoxelWallDistance distance =
        voxel_wall_distance(nodes.grid, vessel, CubeMarks(nodes.grid));
    nodes.type.assign(nodes.grid.num_voxels(), static_cast<std::uint8_t>(NodeType::unused));
    std::size_t index = 0;
    for (int k = 0; k < nodes.grid.dims[2]; ++k)
        for (int j = 0; j < nodes.grid.dims[1]; ++j)
            for (int i = 0; i < nodes.grid.dims[0]; ++i, ++index)
                if (distance_at(distance, i, j, k) < 0.0F)
                    nodes.type[index] = static_cast<std::uint8_t>(NodeType::fluid);
    Layer layer(nodes, vessel, distance);
    layer.trim_caps();
    layer.mark_surroundings();
    add_resistance(nodes, field);
    return nodes;
}

double resistance_integral(const LatticeNodes& nodes)
{
    const double sum = std::accumulate(nodes.darcy.begin(), nodes.darcy.end(), 0.0);
    return sum * std::pow(nodes.grid.spacing, 3);
}

}  // namespace braidzone
