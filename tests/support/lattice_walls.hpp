#pragma once

#include "support/d3q19.hpp"
#include "support/periodic_box.hpp"
#include "support/round_wires.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace braidzone::test {

/// Fluid cells side by side in a row along x.
struct FluidSpan {
    std::ptrdiff_t start = 0;  ///< index of the first one
    int length = 0;
    int z = 0;
};

/// A link from a fluid cell x along c that meets a wall after the part q of its way. What comes
/// back along it, by central linear interpolation, is
///
///     f_in(x, t + 1) = f_out(x) + factor (f_out(x - c) - f_in(x)),
///     factor = (1 - 2 q) / (1 + 2 q)
///
/// with the populations after collision (Ginzburg, Verhaeghe and d'Humieres 2008, Commun. Comput.
/// Phys. 3:427).
struct WallLink {
    std::ptrdiff_t wall_cell = 0;    ///< index of x + c, from which streaming fetches f_in
    std::ptrdiff_t cell = 0;         ///< index of x
    std::ptrdiff_t cell_behind = 0;  ///< index of x - c
    float factor = 0.0F;
    std::int8_t out = 0;  ///< velocity c, into the wall
};

/// The fluid in a box around wires.
struct LatticeWalls {
    std::vector<FluidSpan> spans;
    std::vector<WallLink> links;
};

/// The cells whose centre lies in a wire. Cells without a neighbour outside the wires, enclosed
/// where wires touch, count to them: momentum there would turn round each step and never fade.
/// @return one for each place of an array with ghost cells
inline std::vector<char> cells_in_wires(const PeriodicBox& box, const std::vector<RoundWire>& wires)
{
    std::vector<char> in_wire(static_cast<std::size_t>(box.array_size()), 0);
    const auto at = [&](const std::array<int, 3>& cell) -> char& {
        return in_wire[static_cast<std::size_t>(box.index(box.wrapped(cell)))];
    };
    box.for_each_cell([&](const std::array<int, 3>& cell) {
        at(cell) = std::any_of(wires.begin(), wires.end(), [&](const RoundWire& wire) {
            return wire.distance(Vec3(cell[0], cell[1], cell[2])) < 0.0;
        });
    });
    box.for_each_cell([&](const std::array<int, 3>& cell) {
        bool is_enclosed = true;
        for (int i = 1; i < d3q19::num_velocities; ++i)
            is_enclosed = is_enclosed && at(d3q19::moved(cell, i)) != 0;
        if (is_enclosed) at(cell) = 1;
    });
    return in_wire;
}

/// @param is_solid   of each place of an array with ghost cells, as `cells_in_wires` returns it
/// @param free_part  of a link (cell, velocity) before it meets the wall, 0 to 1
template <typename FreePart>
LatticeWalls walls_around(const PeriodicBox& box, const std::vector<char>& is_solid,
                          FreePart free_part)
{
    const auto is_wall = [&](const std::array<int, 3>& cell) {
        return is_solid[static_cast<std::size_t>(box.index(box.wrapped(cell)))] != 0;
    };
    LatticeWalls walls;
    box.for_each_cell([&](const std::array<int, 3>& cell) {
        if (is_wall(cell)) return;
        const std::array<int, 3> left{cell[0] - 1, cell[1], cell[2]};
        if (cell[0] == 0 || is_wall(left)) walls.spans.push_back({box.index(cell), 0, cell[2]});
        ++walls.spans.back().length;
        for (int i = 1; i < d3q19::num_velocities; ++i) {
            const std::array<int, 3> ahead = d3q19::moved(cell, i);
            if (!is_wall(ahead)) continue;
            const auto& c = d3q19::velocity[static_cast<std::size_t>(i)];
            const double q = free_part(Vec3(cell[0], cell[1], cell[2]), Vec3(c[0], c[1], c[2]));
            WallLink link;
            link.wall_cell = box.index(box.wrapped(ahead));
            link.cell = link.cell_behind = box.index(cell);
            link.out = static_cast<std::int8_t>(i);
            const std::array<int, 3> behind = d3q19::moved(cell, d3q19::opposite(i));
            // Between walls less than two cells apart the wall is taken as half-way.
            if (!is_wall(behind)) {
                link.cell_behind = box.index(box.wrapped(behind));
                link.factor = static_cast<float>((1.0 - 2.0 * q) / (1.0 + 2.0 * q));
            }
            walls.links.push_back(link);
        }
    });
    return walls;
}

/// @param wires  with their images in the boxes around, see `with_images`
inline LatticeWalls lattice_walls(const PeriodicBox& box, const std::vector<RoundWire>& wires)
{
    return walls_around(box, cells_in_wires(box, wires), [&](const Vec3& cell, const Vec3& c) {
        double q = 1.0;
        for (const RoundWire& wire : wires)
            q = std::min(q, free_part(wire, cell, c));
        return q;
    });
}

/// Walls half-way between fluid and solid cells.
/// @param is_solid  of each cell of the box, in the order of `for_each_cell`
inline LatticeWalls halfway_walls(const PeriodicBox& box, const std::vector<char>& is_solid)
{
    std::vector<char> with_ghosts(static_cast<std::size_t>(box.array_size()), 0);
    auto next = is_solid.begin();
    box.for_each_cell([&](const std::array<int, 3>& cell) {
        with_ghosts[static_cast<std::size_t>(box.index(cell))] = *next++;
    });
    return walls_around(box, with_ghosts, [](const Vec3&, const Vec3&) { return 0.5; });
}

}  // namespace braidzone::test
