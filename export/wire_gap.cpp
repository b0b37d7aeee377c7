#include "export/wire_gap.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <cmath>

namespace braidzone {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A straight piece of a wire with the box that holds it and half of the reach around.
struct Piece {
    using NT = double;  // names that CGAL's BoxIntersectionBox_d asks for
    using ID = std::size_t;
    static int dimension() { return 3; }
    ID id() const { return number; }
    NT min_coord(int axis) const { return std::min(from[axis], to[axis]) - margin; }
    NT max_coord(int axis) const { return std::max(from[axis], to[axis]) + margin; }

    std::size_t number = 0;
    std::size_t wire = 0;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double margin = 0.0;
};

double squared_distance(const Piece& a, const Piece& b)
{
    const auto segment = [](const Piece& piece) {
        const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
        return Kernel::Segment_3(point(piece.from), point(piece.to));
    };
    return CGAL::squared_distance(segment(a), segment(b));
}

}  // namespace

WireGap smallest_gap(const std::vector<std::vector<Vec3>>& lines, double reach, double closer)
{
    std::vector<Piece> pieces;
    for (std::size_t wire = 0; wire < lines.size(); ++wire)
        for (std::size_t i = 0; i + 1 < lines[wire].size(); ++i)
            pieces.push_back(
                {pieces.size(), wire, lines[wire][i], lines[wire][i + 1], 0.5 * reach});
    WireGap gap;
    double smallest = reach * reach;
    std::size_t at_piece = pieces.size();
    CGAL::box_self_intersection_d(
        pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
            if (a.wire == b.wire) return;
            const double squared = squared_distance(a, b);
            gap.num_closer += squared < closer * closer;
            const Piece& first = a.number < b.number ? a : b;
            // Of equal distances the first one, whatever the order of the pairs.
            if (squared < smallest || (squared == smallest && first.number < at_piece)) {
                smallest = squared;
                at_piece = first.number;
                gap.distance = std::sqrt(squared);
                gap.place = 0.5 * (first.from + first.to);
            }
        });
    return gap;
}

}  // namespace braidzone
