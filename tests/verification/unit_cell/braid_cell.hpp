#pragma once

#include "porous/rhombus.hpp"
#include "support/round_wires.hpp"

#include <cmath>
#include <vector>

namespace braidzone::test {

/// A flat braid: two layers of straight parallel round wires, in touch.
struct Braid {
    double solidity = 0.0;        ///< s = d / p of both layers [-]
    double crossing_angle = 0.0;  ///< between the layers' wires, acute or right [rad]
};

/// The periodic cell of a braid on a lattice. In the plane it is the rhombus between crossings,
/// x along its longer diagonal; the flow through the braid is along z.
struct BraidCell {
    PeriodicBox box;
    std::vector<RoundWire> wires;  ///< one of each layer
    double spacing = 0.0;          ///< p, of the wires [lattice units]
    double wire_diameter = 0.0;    ///< d [lattice units]
    double crossing_angle = 0.0;   ///< of the cell, which has whole numbers of lattice units [rad]
    double mid_plane = 0.0;        ///< z between the layers
};

/// Lays a braid on a lattice. The rectangle with the rhombus' diagonals as edges, nx by 2 ny,
/// repeats a centred pattern; half of it, with a shift of nx / 2, is one rhombus. Of the widths up
/// to 5 % larger than asked for it takes that whose crossing angle is nearest.
/// @param cells_per_diameter  d [lattice units]; the cell's is up to 5 % larger
/// @param height              of the box, in spacings of the wires
inline BraidCell make_braid_cell(const Braid& braid, double cells_per_diameter, double height)
{
    const double half_angle = 0.5 * braid.crossing_angle;
    const double asked = 0.5 * cells_per_diameter / braid.solidity / std::sin(half_angle);
    constexpr double round_off = 1e-6;
    BraidCell cell;
    double least = 1.0;
    for (int half_width = static_cast<int>(std::ceil(asked - round_off));
         half_width <= 1.05 * asked + 1.0; ++half_width) {
        const int depth = static_cast<int>(std::lround(half_width * std::tan(half_angle)));
        const double angle = 2.0 * std::atan2(depth, half_width);
        const double error = std::abs(angle - braid.crossing_angle);
        if (error < least - 1e-4) {
            least = error;
            cell.crossing_angle = angle;
            cell.box.dims = {2 * half_width, depth, 0};
            cell.box.shift = half_width;
        }
    }
    cell.spacing = cell.box.dims[0] * std::sin(0.5 * cell.crossing_angle);
    cell.wire_diameter = braid.solidity * cell.spacing;
    cell.box.dims[2] = static_cast<int>(std::lround(height * cell.spacing));

    // A place that is no special one on the lattice.
    const Vec3 crossing(0.21, 0.34, 0.5 * cell.box.dims[2] + 0.17);
    cell.mid_plane = crossing.z();
    const double radius = 0.5 * cell.wire_diameter;
    const double c = std::cos(0.5 * cell.crossing_angle), s = std::sin(0.5 * cell.crossing_angle);
    cell.wires = {{crossing - radius * Vec3::UnitZ(), Vec3(c, s, 0), radius},
                  {crossing + radius * Vec3::UnitZ(), Vec3(-c, s, 0), radius}};
    return cell;
}

/// The same cell for the resistance laws, in lattice units.
inline Rhombus rhombus_of(const BraidCell& cell)
{
    const Vec3 along_x = cell.box.image(1, 0, 0);
    const Vec3 edge_a = cell.box.image(0, 1, 0);
    return measure_rhombus(edge_a, edge_a - along_x, cell.wire_diameter, along_x);
}

}  // namespace braidzone::test
