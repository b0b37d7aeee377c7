#include "export/wire_path.hpp"

#include "export/braid_cells.hpp"

#include <numbers>

namespace braidzone {

namespace {

/// Catmull-Rom spline between p1 and p2, t from 0 to 1.
Vec3 catmull_rom(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3, double t)
{
    return 0.5 * (2.0 * p1 + t * (p2 - p0 +
                                  t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 +
                                       t * (3.0 * p1 - p0 - 3.0 * p2 + p3))));
}

/// Calls visit(ring, t) for each place along a wire: t of the way from a ring to the next.
template <typename Visit>
void for_each_place(const BraidLattice& lattice, int pieces_per_arm, Visit visit)
{
    const int last = lattice.num_rings - 1;
    for (int ring = 0; ring < last; ++ring)
        for (int piece = 0; piece < pieces_per_arm; ++piece)
            visit(ring, static_cast<double>(piece) / pieces_per_arm);
    visit(last, 0.0);
}

}  // namespace

std::vector<Wire> wires_of(const BraidLattice& lattice)
{
    std::vector<Wire> wires;
    for (const WireFamily family : {WireFamily::right_handed, WireFamily::left_handed})
        for (int number = 0; number < lattice.nodes_per_ring; ++number)
            wires.push_back({family, number});
    return wires;
}

int column_of_wire(const BraidLattice& lattice, Wire wire, int ring)
{
    if (wire.family == WireFamily::left_handed) return wire.number;
    const int n = lattice.nodes_per_ring;
    return ((wire.number - ring) % n + n) % n;
}

std::vector<Vec3> spline_along_wire(const BraidLattice& lattice, const std::vector<Vec3>& of_nodes,
                                    Wire wire, int pieces_per_arm)
{
    const int last = lattice.num_rings - 1;
    const auto crossing = [&](int ring) -> const Vec3& {
        return of_nodes[static_cast<std::size_t>(
            lattice.node(ring, column_of_wire(lattice, wire, ring)))];
    };
    const auto crossing_or_beyond = [&](int ring) -> Vec3 {
        if (ring < 0) return 2.0 * crossing(0) - crossing(1);
        if (ring > last) return 2.0 * crossing(last) - crossing(last - 1);
        return crossing(ring);
    };
    std::vector<Vec3> values;
    for_each_place(lattice, pieces_per_arm, [&](int ring, double t) {
        values.push_back(catmull_rom(crossing_or_beyond(ring - 1), crossing(ring),
                                     crossing_or_beyond(ring + 1), crossing_or_beyond(ring + 2),
                                     t));
    });
    return values;
}

std::vector<Vec2> surface_coordinates_along_wire(const BraidLattice& lattice, Wire wire,
                                                 int pieces_per_arm)
{
    const double circumference = 2.0 * std::numbers::pi * lattice.nominal_radius;
    const double step_around =
        wire.family == WireFamily::right_handed ? -lattice.arm_width : lattice.arm_width;
    std::vector<Vec2> coordinates;
    for_each_place(lattice, pieces_per_arm, [&](int ring, double t) {
        const Vec2 start = surface_coordinates(lattice, ring, column_of_wire(lattice, wire, ring));
        const double around = start[0] + t * step_around;
        coordinates.emplace_back(around < 0.0 ? around + circumference : around,
                                 start[1] + t * lattice.ring_spacing);
    });
    return coordinates;
}

}  // namespace braidzone
